// Requests as launches of kernels.
#include "server/device/cuda/cuda_device.h"

#include <algorithm>

#include "server/device/cuda/kernel_options.h"
#include "server/device/cuda/structure.h"
#include "server/device/outputs.h"
#include "server/system/stopwatch.h"

namespace raywalk::cuda {
namespace {

constexpr u64 kRaysAtOnce = 1u << 22;  // of a long list

u32 blocks_for(u64 threads, u32 block) {
  return static_cast<u32>((threads + block - 1) / block);
}

FrameBatch batch_of(std::span<const FrameJob> jobs) {
  FrameBatch batch{frame_args(jobs.front()), {}};
  std::ranges::transform(jobs, batch.cameras, [](const FrameJob& job) { return frame_args(job).camera; });
  return batch;
}

const CudaStructure& structure_of(const std::shared_ptr<const Structure>& structure) {
  return dynamic_cast<const CudaStructure&>(*structure);
}

const TraversalType& type_of(const FrameJob& job) {
  return traversal_type(job.structure->kind(), job.traversal);
}

void check_batch(std::span<const FrameJob> jobs) {
  if (jobs.empty() || jobs.size() > FrameBatch::kMax)
    throw std::invalid_argument("a batch has 1 to " + std::to_string(FrameBatch::kMax) + " frames");
  const FrameJob& a = jobs.front();
  for (const FrameJob& b : jobs) {
    const bool alike = a.structure == b.structure && a.traversal == b.traversal && a.width == b.width &&
                       a.height == b.height && a.mode == b.mode && a.depth == b.depth && a.lights == b.lights &&
                       a.kernel == b.kernel;
    if (!alike) throw std::invalid_argument("the frames of a batch differ in their cameras alone");
  }
}

std::vector<KindInfo> kinds_with_kernels() {
  std::vector<KindInfo> all;
  for (const Kind* kind : kinds()) {
    KindInfo info{std::string(kind->name), std::string(kind->help), kind->options, {}};
    for (const TraversalType& type : traversal_types()) {
      if (type.structure != kind->name) continue;
      info.traversals.push_back({std::string(type.traversal), std::string(type.help), false, kernel_options(type)});
    }
    all.push_back(std::move(info));
  }
  return all;
}

const Kind& kind_of(const std::string& name) {
  for (const Kind* kind : kinds())
    if (kind->name == name) return *kind;
  throw std::invalid_argument("unknown structure kind " + name);
}

/// Program::trace or Program::count for ray lists.
KernelSpec ray_kernel(const RayJob& job, Program program) {
  const TraversalType& type = traversal_type(job.structure->kind(), job.traversal);
  return kernel_spec(type, job.kernel, program, Mode::primary, 0, job.structure->form());
}

KernelSpec fault_spec() {
  KernelSpec spec;
  spec.program = Program::fault;
  return spec;
}

}  // namespace

// The kernel that fails is always loaded: it shows at once whether compiler, driver and GPU go together.
CudaDevice::CudaDevice(std::shared_ptr<const Context> context, std::shared_ptr<const Compiler> compiler,
                       std::map<std::string, std::string> details, const CudaConfig& config)
    : context_(std::move(context)),
      stream_(std::make_shared<const Stream>(context_)),
      memory_(std::make_shared<Residency>(context_, stream_, config.memory_limit_bytes)),
      kernels_(context_, std::move(compiler)),
      launch_(*stream_, config.fault_after, kernels_.get(fault_spec(), "fault").function),
      timer_(context_),
      readback_(context_, *stream_),
      sensors_(context_->facts().pci_bus_id),
      host_(config.threads),
      info_{context_->facts().name, "cuda", host_.threads(), std::move(details)},
      kinds_(kinds_with_kernels()),
      all_features_(config.all_features) {
  const std::string version = sensors_.driver_version();
  const std::string cuda = "CUDA " + version_text(context_->driver().version);
  info_.details["driver"] = version.empty() ? cuda : version + " (" + cuda + ")";
  if (!sensors_.why_not().empty()) info_.details["sensors"] = "none (" + sensors_.why_not() + ")";
  info_.details["architecture"] = context_->facts().architecture;
  info_.details["multiprocessors"] = std::to_string(context_->facts().multiprocessors);
}

template <class Work>
auto CudaDevice::guarded(Work work) {
  if (lost_) throw DeviceLost(*lost_);
  const Residency::Working working(*memory_);
  for (bool again = true;; again = false) {
    try {
      context_->make_current();
      return work();
    } catch (const CudaError& error) {
      if (!again || error.code() != CUDA_ERROR_OUT_OF_MEMORY || !memory_->drop_all()) rethrow(error);
    }
  }
}

void CudaDevice::rethrow(const CudaError& error) {
  const bool lost = error.context_is_lost() || context_->driver().cuStreamSynchronize(stream_->get()) != CUDA_SUCCESS;
  if (lost) {
    lost_ = error.what();
    throw DeviceLost(*lost_);
  }
  if (error.code() == CUDA_ERROR_OUT_OF_MEMORY) throw OutOfDeviceMemory(0, memory_->free_bytes());
  throw error;
}

std::shared_ptr<const Structure> CudaDevice::build(std::shared_ptr<const Blob> scene, const std::string& kind,
                                                   const OptionValues& options) {
  if (lost_) throw DeviceLost(*lost_);
  const Kind& known = kind_of(kind);
  BuiltStructure built =
      host_.inside([&] { return known.build(SceneView{scene->data()}, with_defaults(known, options)); });
  const auto blob = std::make_shared<const Blob>(std::move(built.blob));
  auto structure = std::make_shared<const CudaStructure>(kind, built.stats, built.form, memory_->copy_of(scene),
                                                         memory_->copy_of(blob));
  guarded([&] { hold(*structure); });
  return structure;
}

CudaDevice::OnDevice CudaDevice::hold(const CudaStructure& structure) {
  return {memory_->hold(structure.scene_copy()), memory_->hold(structure.copy())};
}

CudaDevice::OnDevice CudaDevice::hold(const FrameJob& job) {
  return hold(structure_of(job.structure));
}

KernelSpec CudaDevice::spec_of(const FrameJob& job, Program program) const {
  const u32 features = all_features_ ? kAllFeatures : structure_of(job.structure).scene().header().features;
  return kernel_spec(type_of(job), job.kernel, program, job.mode, features, job.structure->form());
}

template <class... Arguments>
double CudaDevice::timed(Kernel& kernel, const Grid& grid, const Arguments&... arguments) {
  if (!kernel.ran) launch_(kernel.function, {1, 1, grid.block}, arguments...);
  kernel.ran = true;
  timer_.start(*stream_);
  launch_(kernel.function, grid, arguments...);
  timer_.stop(*stream_);
  return timer_.ms();
}

double CudaDevice::shade(std::span<const FrameJob> jobs, const OnDevice& data, const Residency::Scratch& pixels) {
  const FrameJob& job = jobs.front();
  const KernelSpec spec = spec_of(job, Program::frame);
  Kernel& kernel = kernels_.get(spec, "frame");
  const Grid grid{blocks_for(padded_rays(job.width, job.height), spec.block), static_cast<u32>(jobs.size()),
                  spec.block};
  return timed(kernel, grid, data.scene.address(), data.structure.address(), batch_of(jobs), pixels.address());
}

Residency::Scratch CudaDevice::primary_rays(std::span<const FrameJob> jobs) {
  const FrameJob& job = jobs.front();
  const KernelSpec spec = spec_of(job, Program::trace);
  const u64 rays_per_frame = padded_rays(job.width, job.height);
  Residency::Scratch rays = memory_->scratch(jobs.size() * rays_per_frame * sizeof(Ray));
  const Grid grid{blocks_for(rays_per_frame, spec.block), static_cast<u32>(jobs.size()), spec.block};
  launch_(kernels_.get(spec, "primary_rays").function, grid, batch_of(jobs), rays_per_frame, rays.address());
  return rays;
}

double CudaDevice::trace(std::span<const FrameJob> jobs, const OnDevice& data, const Residency::Scratch& hits) {
  const FrameJob& job = jobs.front();
  const KernelSpec spec = spec_of(job, Program::trace);
  Kernel& kernel = kernels_.get(spec, "closest");
  const Residency::Scratch rays = primary_rays(jobs);
  const u64 count = jobs.size() * padded_rays(job.width, job.height);
  return timed(kernel, {blocks_for(count, spec.block), 1, spec.block}, data.scene.address(), data.structure.address(),
               rays.address(), count, hits.address());
}

void CudaDevice::render(const FrameJob& job, Frame& frame) {
  if (job.output == Output::steps) return render_steps(job, frame);
  if (job.output != Output::color) {
    PrimaryHits primary;
    trace_primary(job, primary);
    image_of_hits(job, structure_of(job.structure).scene(), primary.hits, frame);
    frame.trace_ms = primary.trace_ms;
    return;
  }
  shape_frame(job, 3, frame);
  guarded([&] {
    const u64 bytes = frame.pixels.size() * sizeof(float);
    const OnDevice data = hold(job);
    const Residency::Scratch pixels = memory_->scratch(bytes);
    frame.trace_ms = shade({&job, 1}, data, pixels);
    const Stopwatch watch;
    readback_.copy(pixels.address(), frame.pixels.data(), bytes);
    frame.readback_ms = watch.ms();
  });
}

void CudaDevice::trace_primary(const FrameJob& job, PrimaryHits& result) {
  hits_.resize(padded_rays(job.width, job.height));
  guarded([&] {
    const u64 bytes = hits_.size() * sizeof(Hit);
    const OnDevice data = hold(job);
    const Residency::Scratch hits = memory_->scratch(bytes);
    result.trace_ms = trace({&job, 1}, data, hits);
    readback_.copy(hits.address(), hits_.data(), bytes);
  });
  result.hits.resize(u64{job.width} * job.height);
  in_block_order(job.width, job.height,
                 [&](u32 x, u32 y, u64 thread) { result.hits[u64{y} * job.width + x] = hits_[thread]; });
}

void CudaDevice::render_steps(const FrameJob& job, Frame& frame) {
  std::vector<Counts> counts(padded_rays(job.width, job.height));
  guarded([&] {
    FrameJob primary = job;
    primary.mode = Mode::primary;
    const KernelSpec spec = spec_of(primary, Program::count);
    Kernel& kernel = kernels_.get(spec, "count_rays");
    const OnDevice data = hold(job);
    const u64 count = counts.size(), bytes = count * sizeof(Counts);
    const Residency::Scratch rays = primary_rays({&job, 1});
    const Residency::Scratch out = memory_->scratch(bytes);
    frame.trace_ms = timed(kernel, {blocks_for(count, spec.block), 1, spec.block}, data.scene.address(),
                           data.structure.address(), rays.address(), count, out.address());
    readback_.copy(out.address(), counts.data(), bytes);
  });
  image_of_steps(
      job, [&](u64 thread) { return counts[thread]; }, frame);
}

double CudaDevice::measure(std::span<const FrameJob> jobs, Work work) {
  check_batch(jobs);
  const FrameJob& job = jobs.front();
  return guarded([&] {
    const OnDevice data = hold(job);
    if (work == Work::frame)
      return shade(jobs, data, memory_->scratch(jobs.size() * u64{job.width} * job.height * sizeof(Vec3)));
    return trace(jobs, data, memory_->scratch(jobs.size() * padded_rays(job.width, job.height) * sizeof(Hit)));
  });
}

std::optional<KernelFigures> CudaDevice::kernel_figures(const FrameJob& job, Work work) {
  return guarded([&] {
    const bool frame = work == Work::frame;
    const KernelSpec spec = spec_of(job, frame ? Program::frame : Program::trace);
    return kernels_.get(spec, frame ? "frame" : "closest").figures;
  });
}

DeviceMemory CudaDevice::memory() const {
  DeviceMemory now{context_->facts().memory_bytes, 0, memory_->resident_bytes()};
  try {
    now.free_bytes = memory_->free_bytes();
  } catch (const CudaError&) {
    now.free_bytes = 0;  // of a lost device nothing can be used
  }
  return now;
}

Counts CudaDevice::count(const FrameJob& job) {
  return guarded([&] {
    const KernelSpec spec = spec_of(job, Program::count);
    const CUfunction kernel = kernels_.get(spec, "count_frame").function;
    const OnDevice data = hold(job);
    const Residency::Scratch sum = memory_->scratch(sizeof(Counts));
    RW_CUDA(context_->driver(), cuMemsetD8Async, sum.address(), 0, sizeof(Counts), stream_->get());
    launch_(kernel, {blocks_for(padded_rays(job.width, job.height), spec.block), 1, spec.block}, data.scene.address(),
            data.structure.address(), batch_of({&job, 1}), sum.address());
    Counts counts{};
    readback_.copy(sum.address(), &counts, sizeof counts);
    return counts;
  });
}

bool CudaDevice::can_count(const std::string& kind) const {
  kind_of(kind);
  return true;
}

template <class Answer>
std::vector<Answer> CudaDevice::answers(const RayJob& job, Program program, const char* entry) {
  const KernelSpec spec = ray_kernel(job, program);
  std::vector<Answer> all(job.rays.size());
  if (all.empty()) return all;
  guarded([&] {
    const CUfunction kernel = kernels_.get(spec, entry).function;
    const OnDevice data = hold(structure_of(job.structure));
    const u64 most = std::min<u64>(all.size(), kRaysAtOnce);
    const Residency::Scratch rays = memory_->scratch(most * sizeof(Ray)), out = memory_->scratch(most * sizeof(Answer));
    for (u64 first = 0; first < all.size(); first += most) {
      const u64 count = std::min<u64>(most, all.size() - first);
      RW_CUDA(context_->driver(), cuMemcpyHtoDAsync, rays.address(), job.rays.data() + first, count * sizeof(Ray),
              stream_->get());
      launch_(kernel, {blocks_for(count, spec.block), 1, spec.block}, data.scene.address(), data.structure.address(),
              rays.address(), count, out.address());
      readback_.copy(out.address(), all.data() + first, count * sizeof(Answer));
    }
  });
  return all;
}

std::vector<double> CudaDevice::measure_rays(const RayJob& job, RayQuery query, u32 launches) {
  const bool closest = query == RayQuery::closest;
  const KernelSpec spec = ray_kernel(job, Program::trace);
  return guarded([&] {
    std::vector<double> ms;
    const u64 count = job.rays.size();
    if (count == 0) return std::vector<double>(launches, 0.0);
    Kernel& kernel = kernels_.get(spec, closest ? "closest" : "occluded");
    const OnDevice data = hold(structure_of(job.structure));
    const Residency::Scratch rays = memory_->scratch(count * sizeof(Ray));
    const Residency::Scratch out = memory_->scratch(count * (closest ? sizeof(Hit) : sizeof(u8)));
    RW_CUDA(context_->driver(), cuMemcpyHtoDAsync, rays.address(), job.rays.data(), count * sizeof(Ray),
            stream_->get());
    for (u32 i = 0; i < launches; ++i) {
      ms.push_back(timed(kernel, {blocks_for(count, spec.block), 1, spec.block}, data.scene.address(),
                         data.structure.address(), rays.address(), count, out.address()));
    }
    return ms;
  });
}

std::vector<Hit> CudaDevice::closest(const RayJob& job) {
  return answers<Hit>(job, Program::trace, "closest");
}
std::vector<u8> CudaDevice::occluded(const RayJob& job) {
  return answers<u8>(job, Program::trace, "occluded");
}
std::vector<Counts> CudaDevice::count_rays(const RayJob& job) {
  return answers<Counts>(job, Program::count, "count_rays");
}

}  // namespace raywalk::cuda
