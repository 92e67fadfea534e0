// Embree as a kind of structure: the fast CPU engine, and an independent reference.
#include <atomic>
#include <stdexcept>

#include "kernels/frame_cpu.h"
#include "kernels/shade/direct_batch.h"
#include "server/device/cpu/cpu_kind.h"
#include "server/device/cpu/embree_tracer.h"
#include "server/system/stopwatch.h"

namespace raywalk {
namespace {

/// The process's one Embree device; it counts the memory that its scenes take.
class EmbreeDevice {
 public:
  static EmbreeDevice& instance() {
    static EmbreeDevice device;
    return device;
  }
  RTCDevice handle() const { return device_; }
  u64 bytes() const { return static_cast<u64>(bytes_.load()); }

 private:
  EmbreeDevice() : device_(rtcNewDevice(nullptr)) {
    if (!device_) throw std::runtime_error("Embree: no device: error " + std::to_string(rtcGetDeviceError(nullptr)));
    rtcSetDeviceMemoryMonitorFunction(
        device_,
        [](void* self, ssize_t bytes, bool) {
          static_cast<EmbreeDevice*>(self)->bytes_ += bytes;
          return true;
        },
        this);
  }
  ~EmbreeDevice() { rtcReleaseDevice(device_); }
  std::atomic<long long> bytes_{0};
  RTCDevice device_;
};

class EmbreeStructure final : public CpuStructure {
 public:
  EmbreeStructure(std::shared_ptr<const Blob> scene, std::vector<u32> indices, RTCScene handle, BuildStats stats)
      : CpuStructure(std::move(scene), "embree", stats), indices_(std::move(indices)), handle_(handle) {}
  ~EmbreeStructure() override { rtcReleaseScene(handle_); }
  const void* handle() const override { return handle_; }

 private:
  std::vector<u32> indices_;  // shared with Embree
  RTCScene handle_;
};

RTCScene scene_of(const void* structure) {
  return static_cast<RTCScene>(const_cast<void*>(structure));
}

std::shared_ptr<const CpuStructure> build(std::shared_ptr<const Blob> scene, const Kind*, const OptionValues& options) {
  const Stopwatch watch;
  EmbreeDevice& device = EmbreeDevice::instance();
  const u64 bytes_before = device.bytes();
  const SceneView view{scene->data()};
  const u32 count = view.triangle_count();
  std::vector<u32> indices(u64{count} * 3);
  for (u64 i = 0; i < indices.size(); ++i) indices[i] = static_cast<u32>(i);

  const auto option = [&](const char* name, double fallback) {
    const auto found = options.find(name);
    return found == options.end() ? fallback : found->second;
  };
  RTCScene handle = rtcNewScene(device.handle());
  rtcSetSceneFlags(handle, option("robust", 0) != 0 ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  rtcSetSceneBuildQuality(handle, option("quality", 0) != 0 ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
  if (count > 0) {
    RTCGeometry geometry = rtcNewGeometry(device.handle(), RTC_GEOMETRY_TYPE_TRIANGLE);
    // Corners are three vertices of 16 bytes each, so the scene's own bytes serve as the vertex buffer.
    static_assert(sizeof(Corners) == 48);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, view.corners(), 0, 16,
                               indices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices.data(), 0, 12, count);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(handle, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcJoinCommitScene(handle);
  const RTCError error = rtcGetDeviceError(device.handle());
  if (error != RTC_ERROR_NONE) {
    rtcReleaseScene(handle);
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw std::runtime_error("Embree: the scene was not built: error " + std::to_string(error));
  }
  BuildStats stats;
  stats.references = count;
  stats.size_bytes = device.bytes() - bytes_before + indices.size() * sizeof(u32);
  stats.build_ms = watch.ms();
  return std::make_shared<EmbreeStructure>(std::move(scene), std::move(indices), handle, stats);
}

template <u32 N>
void closest(const TraceTarget& target, const Ray* rays, u64 count, Hit* hits) {
  closest_hits(embree::Tracer<N, embree::NoRayCount>{scene_of(target.structure)}, rays, count, hits);
}

template <u32 N>
void occluded(const TraceTarget& target, const Ray* rays, u64 count, u8* out) {
  any_hits(embree::Tracer<N, embree::NoRayCount>{scene_of(target.structure)}, rays, count, out);
}

/// Mode::primary: a block is traced, the triangles that it met are prefetched, and then it is shaded.
template <u32 N>
void primary_block(SceneView scene, RTCScene handle, const FrameArgs& args, Tile tile, u32 bx, u32 by, Vec3* pixels) {
  alignas(64) typename embree::Packet<N>::RayHits packets[kBlockRays / N];
  alignas(64) int valid[kBlockRays / N][N];
  for (u32 p = 0; p < kBlockRays / N; ++p) {
    embree::fill_primary<N>(packets[p], valid[p], args.camera, bx, by, p * N, tile);
    embree::Packet<N>::intersect(valid[p], handle, embree::Coherence::coherent, &packets[p]);
    for (u32 i = 0; i < N; ++i) {
      if (packets[p].hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
      __builtin_prefetch(scene.corners() + packets[p].hit.primID[i]);
      __builtin_prefetch(scene.triangles() + packets[p].hit.primID[i]);
    }
  }
  const Vec3 background = scene.header().background;
  const float spread = spread_of(args.camera);
  const u32 lights = lights_of<kAllFeatures>(scene, args.lights);
  for (u32 lane = 0; lane < kBlockRays; lane += kBatch) {
    const auto& packet = packets[lane / N];
    Vec3Batch colors;
    embree::shade<N>(scene, packet, lane % N, spread, lights, colors);
    for (u32 i = 0; i < kBatch; ++i) {
      if (!valid[lane / N][lane % N + i]) continue;
      const bool hit = packet.hit.geomID[lane % N + i] != RTC_INVALID_GEOMETRY_ID;
      pixels[u64{by + block_y(lane + i)} * args.width + bx + block_x(lane + i)] = hit ? colors.get(i) : background;
    }
  }
}

template <u32 N>
void frame(const TraceTarget& target, const FrameArgs& args, Tile tile, Vec3* pixels) {
  if (args.mode == Mode::primary) {
    for (u32 by = tile.y0; by < tile.y1; by += kBlockSide)
      for (u32 bx = tile.x0; bx < tile.x1; bx += kBlockSide)
        primary_block<N>(target.scene, scene_of(target.structure), args, tile, bx, by, pixels);
    return;
  }
  embree::Tracer<N, embree::NoRayCount> tracer{scene_of(target.structure)};
  shade_tile<ErrorBoundOffset>(tracer, target.scene, args, tile,
                               [&](u32 x, u32 y, Vec3 color) { pixels[u64{y} * args.width + x] = color; });
}

template <u32 N>
Counts count_frame(const TraceTarget& target, const FrameArgs& args, Tile tile) {
  embree::Tracer<N, embree::RayCount> tracer{scene_of(target.structure)};
  shade_tile<ErrorBoundOffset>(tracer, target.scene, args, tile, [](u32, u32, Vec3) {});
  return {tracer.count.rays, 0, 0};
}

void count_rays(const TraceTarget&, const Ray*, u64 count, Counts* counts) {
  for (u64 i = 0; i < count; ++i) counts[i] = {1, 0, 0};
}

void loop_1(const void* structure, const FrameArgs& args, Tile tile, Hit* hits) {
  for (u32 y = tile.y0; y < tile.y1; ++y) {
    for (u32 x = tile.x0; x < tile.x1; ++x) {
      const Ray r = primary_ray(args.camera, x, y);
      RTCRayHit one;
      one.ray = {r.o.x, r.o.y, r.o.z, r.tmin, r.d.x, r.d.y, r.d.z, 0.0f, r.tmax, 0xffffffffu, 0, 0};
      one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      embree::intersect(scene_of(structure), &one);
      const u32 id = one.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kMiss : one.hit.primID;
      hits[u64{y} * args.width + x] = {one.ray.tfar, id, one.hit.u, one.hit.v};
    }
  }
}

/// As anyone would write it: rays one by one into a packet, one coherent call, hits out.
void loop_8(const void* structure, const FrameArgs& args, Tile tile, Hit* hits) {
  constexpr u32 kPacket = 8;
  for (u32 by = tile.y0; by < tile.y1; by += kBlockSide) {
    for (u32 bx = tile.x0; bx < tile.x1; bx += kBlockSide) {
      for (u32 first = 0; first < kBlockRays; first += kPacket) {
        alignas(32) RTCRayHit8 packet;
        alignas(32) int valid[kPacket];
        for (u32 i = 0; i < kPacket; ++i) {
          const u32 x = bx + block_x(first + i), y = by + block_y(first + i);
          valid[i] = x < tile.x1 && y < tile.y1 ? -1 : 0;
          embree::set_lane(packet.ray, i, primary_ray(args.camera, x, y));
          packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        embree::Packet<kPacket>::intersect(valid, scene_of(structure), embree::Coherence::coherent, &packet);
        for (u32 i = 0; i < kPacket; ++i) {
          if (!valid[i]) continue;
          hits[u64{by + block_y(first + i)} * args.width + bx + block_x(first + i)] = embree::hit_of(packet, i);
        }
      }
    }
  }
}

/// The traversal in packets of N.
template <u32 N>
CpuTraversal intersect_row(std::string_view help) {
  return {"embree", "intersect", help, 0, closest<N>, occluded<N>, frame<N>, count_frame<N>, count_rays};
}

}  // namespace

CpuKind embree_kind() {
  // Without AVX-512 Embree takes a packet of sixteen apart, ray by ray.
  const bool wide =
      rtcGetDeviceProperty(EmbreeDevice::instance().handle(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
  const CpuTraversal intersect =
      wide ? intersect_row<16>("Embree in packets of sixteen") : intersect_row<8>("Embree in packets of eight");
  CpuKind kind{{"embree", "Intel Embree's own BVH", {}, {}}, build, nullptr, {intersect}};
  kind.loops = {{"loop-1", "bare loop over rtcIntersect1, ray generation included", loop_1},
                {"loop-8", "bare loop over coherent rtcIntersect8, ray generation included", loop_8}};
  kind.counts_work = false;
  kind.info.options = {
      {.name = "robust", .help = "watertight at the cost of speed", .choices = {"off", "on"}},
      {.name = "quality", .help = "build quality", .choices = {"medium", "high"}},
  };
  kind.info.traversals = {{"intersect", std::string(intersect.help)}};
  for (const BareLoop& loop : kind.loops)
    kind.info.traversals.push_back({std::string(loop.name), std::string(loop.help), true});
  return kind;
}

}  // namespace raywalk
