// What the service asks of whatever renders: build structures, render frames, trace rays. One thread at a time may call
// it.
#pragma once
#include <memory>
#include <optional>
#include <span>
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
};

struct KindInfo {
  std::string name;
  std::string help;
  std::vector<BuildOption> options;
  std::vector<TraversalInfo> traversals;
};

/// A structure resident on the device; keeps its scene alive.
class Structure {
 public:
  virtual ~Structure() = default;
  virtual const std::string& kind() const = 0;
  virtual const BuildStats& stats() const = 0;
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
  Output output = Output::color;
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
};

class Device {
 public:
  virtual ~Device() = default;
  /// Of the device itself, such as the processor's model name.
  virtual std::string name() const = 0;
  virtual u32 threads() const = 0;
  virtual const std::vector<KindInfo>& kinds() const = 0;
  /// Throws std::invalid_argument for an option out of range, std::bad_alloc when memory ends.
  virtual std::shared_ptr<const Structure> build(std::shared_ptr<const Blob> scene, const std::string& kind,
                                                 const BuildOptions& options) = 0;
  /// Reuses the storage of `frame`.
  virtual void render(const FrameJob& job, Frame& frame) = 0;
  virtual void trace_primary(const FrameJob& job, PrimaryHits& hits) = 0;
  /// Work of all rays of the frame's mode, from a separately compiled kernel; only `rays` where the technique cannot
  /// count.
  virtual Counts count(const FrameJob& job) = 0;
  /// False when `count` fills in rays alone for this kind of structure.
  virtual bool can_count(const std::string& kind) const = 0;
  /// Invalid rays miss.
  virtual std::vector<Hit> closest(const RayJob& job) = 0;
  /// 1 where the ray is occluded.
  virtual std::vector<u8> occluded(const RayJob& job) = 0;
};

/// The CPU device: the kernels and Embree, on `threads` threads (0 = all processors).
std::unique_ptr<Device> open_cpu_device(u32 threads);

}  // namespace raywalk
