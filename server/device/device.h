// What the service asks of whatever renders: build structures, render frames, trace rays. One thread at a time may call
// it.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernels/accel/kind.h"
#include "kernels/counter.h"
#include "kernels/frame_request.h"
#include "kernels/scene_view.h"

namespace raywalk {

struct TraversalInfo {
  std::string name;
  std::string help;
  /// True for a bare loop that only bounds what is possible: mode trace of a benchmark, nothing else.
  bool baseline = false;
  /// Of the kernel that runs it, such as a register cap; none where the device has no choice.
  std::vector<Option> options = {};
};

struct KindInfo {
  std::string name;
  std::string help;
  std::vector<Option> options;  // of the builder
  std::vector<TraversalInfo> traversals;
};

/// A structure resident on the device; keeps its scene alive.
class Structure {
 public:
  virtual ~Structure() = default;
  virtual const std::string& kind() const = 0;
  virtual const BuildStats& stats() const = 0;
  /// Only traversals whose knobs go with it can use the structure (see `check_form` in knobs.h).
  virtual StructureForm form() const { return {}; }
};

enum class Output { color, depth, normal, id, steps };

/// A frame of `structure`'s scene. `traversal` is one that `kinds()` lists for the structure's kind.
struct FrameJob {
  std::shared_ptr<const Structure> structure;
  std::string traversal;
  CameraPose camera;
  u32 width = 0, height = 0;
  Mode mode = Mode::primary;
  u32 depth = 2;
  u32 lights = kAllLights;  // so many shine, the first ones
  Output output = Output::color;
  OptionValues kernel = {};  // options of the traversal; absent ones have their defaults
};

/// Rows top down, channels interleaved: color and normal 3 (color is linear RGB), depth and id 1, steps 2.
struct Frame {
  u32 width = 0, height = 0, channels = 0;
  std::vector<float> pixels;
  double trace_ms = 0;     // traversal and shading
  double readback_ms = 0;  // 0 on a CPU
};

/// Closest hits of a frame's primary rays in pixel order, timed without ray generation and shading.
struct PrimaryHits {
  std::vector<Hit> hits;
  double trace_ms = 0;
};

struct RayJob {
  std::shared_ptr<const Structure> structure;
  std::string traversal;
  std::span<const Ray> rays;
  OptionValues kernel = {};
};

/// What is asked of each ray of a list.
enum class RayQuery { closest, any };

/// What a benchmark times: closest hits of primary rays that lie in memory, or shaded frames.
enum class Work { trace, frame };

/// The kernel of one measurement, as its driver reports it: a row of the study's Table 3.
struct KernelFigures {
  u32 registers = 0;     // a thread
  u32 local_bytes = 0;   // a thread: stack and spills
  u32 shared_bytes = 0;  // a block
  u32 threads_per_block = 0;
  u32 blocks_per_multiprocessor = 0;  // resident at once
  double occupancy = 0;               // resident threads of those that the multiprocessor could hold
  u64 binary_bytes = 0;
};

/// One reading of the device's sensors.
struct Telemetry {
  u32 core_clock_mhz = 0, memory_clock_mhz = 0;
  double power_w = 0, power_limit_w = 0;
  u32 temperature_c = 0;
  std::vector<std::string> throttle_reasons;  // empty: none
};

/// What the service tells of the device.
struct DeviceInfo {
  std::string name;  // such as the processor's model name
  std::string kind;  // cpu, cuda
  u32 threads = 1;   // of the host that render or build
  /// Driver, compiler, architecture and the like, by name; empty for a CPU.
  std::map<std::string, std::string> details = {};
};

/// Memory of the device itself; all 0 for a CPU, whose structures lie in the daemon's memory.
struct DeviceMemory {
  u64 total_bytes = 0, free_bytes = 0, resident_bytes = 0;
};

/// A request needs more device memory than there is, with everything evicted that nobody uses. `needed_bytes` is 0 when
/// the driver itself ran out and does not tell.
class OutOfDeviceMemory : public std::runtime_error {
 public:
  OutOfDeviceMemory(u64 needed_bytes, u64 free_bytes);
  u64 needed_bytes() const { return needed_bytes_; }
  u64 free_bytes() const { return free_bytes_; }

 private:
  u64 needed_bytes_, free_bytes_;
};

/// The device cannot be used any more by this process: the daemon ends, and its supervisor starts another.
class DeviceLost : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The device's compiler refuses a kernel with these options, such as one that needs more shared memory than a block
/// has. The message is its log, the cause first.
class KernelRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceInfo& info() const = 0;
  virtual const std::vector<KindInfo>& kinds() const = 0;
  /// Throws std::invalid_argument for an option out of range, std::bad_alloc when memory ends.
  virtual std::shared_ptr<const Structure> build(std::shared_ptr<const Blob> scene, const std::string& kind,
                                                 const OptionValues& options) = 0;
  /// Reuses the storage of `frame`.
  virtual void render(const FrameJob& job, Frame& frame) = 0;
  virtual void trace_primary(const FrameJob& job, PrimaryHits& hits) = 0;

  /// Most frames that `measure` takes at once.
  virtual u32 max_batch() const = 0;
  /// Performs `jobs`, which differ in their cameras alone, in one launch and keeps nothing of it. The time in ms of
  /// all together, without transfers, ray generation for Work::trace, and whatever a first use has to prepare.
  virtual double measure(std::span<const FrameJob> jobs, Work work) = 0;
  /// Of the kernel that `measure` runs for such a job; nothing where there is no such thing.
  virtual std::optional<KernelFigures> kernel_figures(const FrameJob& job, Work work) = 0;
  /// Nothing where there are no sensors. From any thread.
  virtual std::optional<Telemetry> telemetry() const = 0;
  /// From any thread.
  virtual DeviceMemory memory() const = 0;

  /// Work of all rays of the frame's mode, from a separately compiled kernel; only `rays` where the technique cannot
  /// count.
  virtual Counts count(const FrameJob& job) = 0;
  /// False when `count` fills in rays alone for this kind of structure.
  virtual bool can_count(const std::string& kind) const = 0;
  /// Invalid rays miss.
  virtual std::vector<Hit> closest(const RayJob& job) = 0;
  /// Work of each ray's closest hit; only `rays` where the technique cannot count.
  virtual std::vector<Counts> count_rays(const RayJob& job) = 0;
  /// 1 where the ray is occluded.
  virtual std::vector<u8> occluded(const RayJob& job) = 0;
  /// Traces the list `launches` times and keeps no answer. The time in ms of each, without transfers and whatever a
  /// first use has to prepare.
  virtual std::vector<double> measure_rays(const RayJob& job, RayQuery query, u32 launches) = 0;
};

/// The CPU device: the kernels and Embree, on `threads` threads (0 = all processors).
std::unique_ptr<Device> open_cpu_device(u32 threads);

struct CudaConfig {
  /// Of compiled kernels; empty: none is kept.
  std::filesystem::path cache_dir;
  /// Of all that the device allocates; 0: as much as the card has.
  u64 memory_limit_bytes = 0;
  /// For tests: the kernel launch with this number traps; 0: none does.
  u64 fault_after = 0;
  /// Of the host, for builds; 0 = all processors.
  u32 threads = 0;
  /// For tests: kernels are compiled with all features, whatever the scene needs.
  bool all_features = false;
};

struct DeviceOrReason {
  std::unique_ptr<Device> device;
  std::string why_not;  // one sentence for people, where there is no device
};

/// The first NVIDIA GPU that the driver shows, with kernels compiled at run time. Whatever is missing is a reason.
DeviceOrReason open_cuda_device(const CudaConfig& config);

}  // namespace raywalk
