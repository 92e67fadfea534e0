// Embree as a tracer of blocks of rays. Invalid rays never reach it: an assertion in it would end the process.
#pragma once
#include "kernels/frame_request.h"
#include "kernels/ray.h"
#include "kernels/shade/direct_batch.h"
#include "server/device/cpu/embree_api.h"

namespace raywalk::embree {

constexpr u32 kPacket = 8;

inline void set_lane(RTCRay8& packet, u32 i, const Ray& r) {
  packet.org_x[i] = r.o.x;
  packet.org_y[i] = r.o.y;
  packet.org_z[i] = r.o.z;
  packet.tnear[i] = r.tmin;
  packet.dir_x[i] = r.d.x;
  packet.dir_y[i] = r.d.y;
  packet.dir_z[i] = r.d.z;
  packet.tfar[i] = r.tmax;
  packet.time[i] = 0.0f;
  packet.mask[i] = 0xffffffffu;
  packet.flags[i] = 0;
}

/// Fills in the rays that are active and valid; returns whether there is any.
inline bool fill(RTCRay8& packet, int* valid, const Ray* rays, const bool* active) {
  bool any = false;
  for (u32 i = 0; i < kPacket; ++i) {
    const bool use = active[i] && is_valid(rays[i]);
    any |= use;
    valid[i] = use ? -1 : 0;
    if (use) set_lane(packet, i, rays[i]);
  }
  return any;
}

/// Eight primary rays of lanes first.. of the block at (bx, by), the same bits as primary_ray but without a detour
/// through single rays; lanes outside the tile are not valid.
void fill_primary(RTCRayHit8& packet, int* valid, const Camera& camera, u32 bx, u32 by, u32 first, const Tile& tile);

/// Hit of lane `i` after intersect8.
inline Hit hit_of(const RTCRayHit8& packet, u32 i) {
  const u32 id = packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? kMiss : packet.hit.primID[i];
  return {packet.ray.tfar[i], id, packet.hit.u[i], packet.hit.v[i]};
}

/// Colours of the packet's hits as `unshadowed` has them; false when there is none.
bool shade(SceneView scene, const RTCRayHit8& packet, Vec3Batch& colors);

/// The primary rays of one block as eight traced packets; lane l of packet p is lane 8p + l of the block.
struct PrimaryBlock {
  u32 bx, by;
  alignas(32) RTCRayHit8 packets[kBlockRays / kPacket];
  alignas(32) int valid[kBlockRays / kPacket][kPacket];
};

/// Traces a tile block by block and calls visit(block).
template <class Visit>
void trace_primary(RTCScene scene, const FrameArgs& args, const Tile& tile, Visit visit) {
  PrimaryBlock block;
  for (block.by = tile.y0; block.by < tile.y1; block.by += kBlockSide) {
    for (block.bx = tile.x0; block.bx < tile.x1; block.bx += kBlockSide) {
      for (u32 p = 0; p < kBlockRays / kPacket; ++p) {
        fill_primary(block.packets[p], block.valid[p], args.camera, block.bx, block.by, p * kPacket, tile);
        intersect8(block.valid[p], scene, Coherence::coherent, &block.packets[p]);
      }
      visit(block);
    }
  }
}

struct RayCount {
  u64 rays = 0;
  void add(const bool* active, u32 count) {
    for (u32 i = 0; i < count; ++i) rays += active[i];
  }
};
struct NoRayCount {
  void add(const bool*, u32) {}
};

template <class CountT>
struct Tracer {
  static constexpr u32 kLocal = kBlockRays;
  RTCScene scene;
  CountT count{};
  bool primary = true;  // the first query of a block is its primary rays

  void closest(const Ray* rays, const bool* active, Hit* hits) {
    count.add(active, kLocal);
    const Coherence coherence = primary ? Coherence::coherent : Coherence::incoherent;
    primary = false;
    for (u32 first = 0; first < kLocal; first += kPacket) {
      alignas(32) RTCRayHit8 packet;
      alignas(32) int valid[kPacket];
      const bool any = fill(packet.ray, valid, rays + first, active + first);
      for (u32 i = 0; i < kPacket; ++i) packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      if (any) intersect8(valid, scene, coherence, &packet);
      for (u32 i = 0; i < kPacket; ++i) {
        if (!active[first + i]) continue;
        const bool hit = valid[i] && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        hits[first + i] = hit ? hit_of(packet, i) : miss_of(rays[first + i]);
      }
    }
  }
  void occluded(const Ray* rays, const bool* active, bool* out) {
    count.add(active, kLocal);
    for (u32 first = 0; first < kLocal; first += kPacket) {
      alignas(32) RTCRay8 packet;
      alignas(32) int valid[kPacket];
      if (fill(packet, valid, rays + first, active + first)) occluded8(valid, scene, Coherence::coherent, &packet);
      for (u32 i = 0; i < kPacket; ++i) out[first + i] = valid[i] && packet.tfar[i] < 0.0f;
    }
  }
  bool any(const bool* flags) const {
    bool result = false;
    for (u32 i = 0; i < kLocal; ++i) result |= flags[i];
    return result;
  }
};

}  // namespace raywalk::embree
