// The CPU device: kernels and Embree behind one interface.
#include <fstream>
#include <mutex>
#include <stdexcept>

#include "server/device/camera.h"
#include "server/device/cpu/cpu_kind.h"
#include "server/device/cpu/tile_runner.h"
#include "server/device/knobs.h"
#include "server/device/outputs.h"
#include "server/system/stopwatch.h"

namespace raywalk {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

class CpuDevice final : public Device {
 public:
  explicit CpuDevice(u32 threads) : runner_(threads), kinds_(kernel_kinds()) {
    kinds_.push_back(embree_kind());
    for (const CpuKind& kind : kinds_) infos_.push_back(kind.info);
  }

  const DeviceInfo& info() const override { return info_; }
  const std::vector<KindInfo>& kinds() const override { return infos_; }

  std::shared_ptr<const Structure> build(std::shared_ptr<const Blob> scene, const std::string& kind,
                                         const OptionValues& options) override {
    const CpuKind& found = kind_of(kind);
    return runner_.inside([&] { return found.build(std::move(scene), found.kind, options); });
  }

  void render(const FrameJob& job, Frame& frame) override {
    if (job.output != Output::color) return render_primary(job, frame);
    const CpuStructure& structure = structure_of(job.structure);
    const CpuTraversal& row = traversal_of(job.structure->kind(), job.traversal);
    const TraceTarget target = target_of(structure, job.kernel);
    const FrameArgs args = frame_args(job);
    shape_frame(job, 3, frame);
    Vec3* pixels = reinterpret_cast<Vec3*>(frame.pixels.data());
    const Stopwatch watch;
    runner_.over_tiles(job.width, job.height, [&](Tile tile) { row.frame(target, args, tile, pixels); });
    frame.trace_ms = watch.ms();
  }

  void trace_primary(const FrameJob& job, PrimaryHits& result) override {
    result.hits.resize(u64{job.width} * job.height);
    if (const BareLoop* loop = loop_of(job.structure->kind(), job.traversal)) {
      result.trace_ms = trace_bare(*loop, job, result.hits);
      return;
    }
    result.trace_ms = trace_in_block_order(job);
    const Hit* next = hits_.data();
    in_block_order(job.width, job.height, [&](u32 x, u32 y, u64) { result.hits[u64{y} * job.width + x] = *next++; });
  }

  u32 max_batch() const override { return 1; }

  double measure(std::span<const FrameJob> jobs, Work work) override {
    if (jobs.size() != 1) throw std::invalid_argument("the CPU takes one frame at a time");
    const FrameJob& job = jobs.front();
    if (work == Work::frame) {
      render(job, measured_);
      return measured_.trace_ms;
    }
    if (const BareLoop* loop = loop_of(job.structure->kind(), job.traversal)) {
      hits_.resize(u64{job.width} * job.height);
      return trace_bare(*loop, job, hits_);
    }
    return trace_in_block_order(job);
  }

  std::optional<KernelFigures> kernel_figures(const FrameJob&, Work) override { return std::nullopt; }
  std::optional<Telemetry> telemetry() const override { return std::nullopt; }
  DeviceMemory memory() const override { return {}; }

  Counts count(const FrameJob& job) override {
    if (loop_of(job.structure->kind(), job.traversal)) return {u64{job.width} * job.height, 0, 0};
    const CpuStructure& structure = structure_of(job.structure);
    const CpuTraversal& row = traversal_of(job.structure->kind(), job.traversal);
    const TraceTarget target = target_of(structure, job.kernel);
    const FrameArgs args = frame_args(job);
    Counts sum{};
    std::mutex mutex;
    runner_.over_tiles(job.width, job.height, [&](Tile tile) {
      const Counts counts = row.count_frame(target, args, tile);
      const std::scoped_lock lock(mutex);
      sum += counts;
    });
    return sum;
  }
  bool can_count(const std::string& kind) const override { return kind_of(kind).counts_work; }

  std::vector<Hit> closest(const RayJob& job) override {
    std::vector<Hit> hits;
    trace(job, &CpuTraversal::closest, hits);
    return hits;
  }
  std::vector<Counts> count_rays(const RayJob& job) override {
    std::vector<Counts> counts;
    trace(job, &CpuTraversal::count_rays, counts);
    return counts;
  }
  std::vector<u8> occluded(const RayJob& job) override {
    std::vector<u8> flags;
    trace(job, &CpuTraversal::occluded, flags);
    return flags;
  }
  std::vector<double> measure_rays(const RayJob& job, RayQuery query, u32 launches) override {
    std::vector<double> ms;
    for (u32 i = 0; i < launches; ++i) {
      const Stopwatch watch;
      if (query == RayQuery::closest) {
        trace(job, &CpuTraversal::closest, hits_);
      } else {
        trace(job, &CpuTraversal::occluded, flags_);
      }
      ms.push_back(watch.ms());
    }
    return ms;
  }

 private:
  template <class Answer>
  void trace(const RayJob& job, void (*CpuTraversal::*query)(const TraceTarget&, const Ray*, u64, Answer*),
             std::vector<Answer>& answers) {
    const CpuTraversal& row = traversal_of(job.structure->kind(), job.traversal);
    const TraceTarget target = target_of(structure_of(job.structure), job.kernel);
    answers.resize(job.rays.size());
    runner_.over_rays(answers.size(), [&](u64 first, u64 last) {
      (row.*query)(target, job.rays.data() + first, last - first, answers.data() + first);
    });
  }
  const CpuKind& kind_of(const std::string& name) const {
    for (const CpuKind& kind : kinds_)
      if (kind.info.name == name) return kind;
    throw std::invalid_argument("unknown structure kind " + name);
  }
  const CpuTraversal& traversal_of(const std::string& kind, const std::string& name) const {
    for (const CpuTraversal& row : kind_of(kind).traversals)
      if (row.name == name) return row;
    throw std::invalid_argument(kind + " has no traversal " + name + " for this use");
  }
  const BareLoop* loop_of(const std::string& kind, const std::string& name) const {
    for (const BareLoop& loop : kind_of(kind).loops)
      if (loop.name == name) return &loop;
    return nullptr;
  }
  static TraceTarget target_of(const CpuStructure& structure, const OptionValues& kernel) {
    check_form(structure.kind(), structure.form(), kernel);
    return {structure.scene(), structure.handle(), knobs_of(kernel)};
  }
  static const CpuStructure& structure_of(const std::shared_ptr<const Structure>& structure) {
    return dynamic_cast<const CpuStructure&>(*structure);
  }
  void prepare_rays(const FrameJob& job) {
    const Camera camera = camera_of(job.camera, job.width, job.height);
    rays_.clear();
    rays_.reserve(u64{job.width} * job.height);
    in_block_order(job.width, job.height, [&](u32 x, u32 y, u64) { rays_.push_back(primary_ray(camera, x, y)); });
  }

  /// Hits of the primary rays into `hits_`, in the order of `in_block_order`; the time in ms.
  double trace_in_block_order(const FrameJob& job) {
    const CpuStructure& structure = structure_of(job.structure);
    const CpuTraversal& row = traversal_of(job.structure->kind(), job.traversal);
    const TraceTarget target = target_of(structure, job.kernel);
    prepare_rays(job);
    hits_.resize(rays_.size());
    const Stopwatch watch;
    runner_.over_rays(rays_.size(), [&](u64 first, u64 last) {
      row.closest(target, rays_.data() + first, last - first, hits_.data() + first);
    });
    return watch.ms();
  }

  /// Into `hits`, which has a place for every pixel; the time in ms.
  double trace_bare(const BareLoop& loop, const FrameJob& job, std::vector<Hit>& hits) {
    const CpuStructure& structure = structure_of(job.structure);
    const FrameArgs args = frame_args(job);
    const Stopwatch watch;
    runner_.over_tiles(job.width, job.height,
                       [&](Tile tile) { loop.trace(structure.handle(), args, tile, hits.data()); });
    return watch.ms();
  }

  /// Outputs that follow from the primary hits alone.
  void render_primary(const FrameJob& job, Frame& frame) {
    const CpuStructure& structure = structure_of(job.structure);
    if (job.output == Output::steps) return render_steps(job, structure, frame);
    PrimaryHits primary;
    trace_primary(job, primary);
    image_of_hits(job, structure.scene(), primary.hits, frame);
    frame.trace_ms = primary.trace_ms;
  }

  void render_steps(const FrameJob& job, const CpuStructure& structure, Frame& frame) {
    const CpuTraversal& row = traversal_of(job.structure->kind(), job.traversal);
    const TraceTarget target = target_of(structure, job.kernel);
    prepare_rays(job);
    std::vector<Counts> counts(rays_.size());
    const Stopwatch watch;
    runner_.over_rays(rays_.size(), [&](u64 first, u64 last) {
      row.count_rays(target, rays_.data() + first, last - first, counts.data() + first);
    });
    frame.trace_ms = watch.ms();
    const Counts* next = counts.data();
    image_of_steps(
        job, [&](u64) { return *next++; }, frame);
  }

  TileRunner runner_;
  DeviceInfo info_{processor_name(), "cpu", runner_.threads()};
  std::vector<CpuKind> kinds_;
  std::vector<KindInfo> infos_;
  std::vector<Ray> rays_;  // reused from frame to frame, as all below
  std::vector<Hit> hits_;
  std::vector<u8> flags_;
  Frame measured_;
};

}  // namespace

std::unique_ptr<Device> open_cpu_device(u32 threads) {
  return std::make_unique<CpuDevice>(threads);
}

}  // namespace raywalk
