// Embree as a tracer of blocks of rays. Invalid rays never reach it: an assertion in it would end the process.
#pragma once
#include "kernels/frame_request.h"
#include "kernels/ray.h"
#include "kernels/shade/direct_batch.h"
#include "server/device/cpu/embree_api.h"

namespace raywalk::embree {

template <class Rays>
void set_lane(Rays& packet, u32 i, const Ray& r) {
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

/// Fills in the N rays that are active and valid; returns whether there is any.
template <u32 N>
bool fill(typename Packet<N>::Rays& packet, int* valid, const Ray* rays, const bool* active) {
  bool any = false;
  for (u32 i = 0; i < N; ++i) {
    const bool use = active[i] && is_valid(rays[i]);
    any |= use;
    valid[i] = use ? -1 : 0;
    if (use) set_lane(packet, i, rays[i]);
  }
  return any;
}

/// Hit of lane `i` after an intersection.
template <class RayHits>
Hit hit_of(const RayHits& packet, u32 i) {
  const u32 id = packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? kMiss : packet.hit.primID[i];
  return {packet.ray.tfar[i], id, packet.hit.u[i], packet.hit.v[i]};
}

/// N primary rays of lanes first.. of the block at (bx, by), the same bits as primary_ray but without a detour through
/// single rays; lanes outside the tile are not valid.
template <u32 N>
void fill_primary(typename Packet<N>::RayHits& packet, int* valid, const Camera& camera, u32 bx, u32 by, u32 first,
                  const Tile& tile);

/// Colours of lanes first.. first + 7 as `unshadowed` has them; false when none of them is a hit.
template <u32 N>
bool shade(SceneView scene, const typename Packet<N>::RayHits& packet, u32 first, float spread, u32 lights,
           Vec3Batch& colors);

struct RayCount {
  u64 rays = 0;
  void add(const bool* active, u32 count) {
    for (u32 i = 0; i < count; ++i) rays += active[i];
  }
};
struct NoRayCount {
  void add(const bool*, u32) {}
};

/// A tracer for `radiance` in packets of N.
template <u32 N, class CountT>
struct Tracer {
  static constexpr u32 kLocal = kBlockRays;
  RTCScene scene;
  CountT count{};
  bool primary = true;  // the first query is the block's primary rays

  void closest(const Ray* rays, const bool* active, Hit* hits) {
    count.add(active, kLocal);
    // Rays that end somewhere are those of a block to one lamp: as alike as primary rays.
    bool alike = true;
    for (u32 i = 0; i < kLocal; ++i) alike &= !active[i] || rays[i].tmax < kMaxFloat;
    const Coherence coherence = primary || alike ? Coherence::coherent : Coherence::incoherent;
    primary = false;
    for (u32 first = 0; first < kLocal; first += N) {
      alignas(64) typename Packet<N>::RayHits packet;
      alignas(64) int valid[N];
      const bool any = fill<N>(packet.ray, valid, rays + first, active + first);
      for (u32 i = 0; i < N; ++i) packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      if (any) Packet<N>::intersect(valid, scene, coherence, &packet);
      for (u32 i = 0; i < N; ++i) {
        if (!active[first + i]) continue;
        const bool hit = valid[i] && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        hits[first + i] = hit ? hit_of(packet, i) : miss_of(rays[first + i]);
      }
    }
  }
  void occluded(const Ray* rays, const bool* active, bool* out) {
    count.add(active, kLocal);
    for (u32 first = 0; first < kLocal; first += N) {
      alignas(64) typename Packet<N>::Rays packet;
      alignas(64) int valid[N];
      if (fill<N>(packet, valid, rays + first, active + first))
        Packet<N>::occluded(valid, scene, Coherence::coherent, &packet);
      for (u32 i = 0; i < N; ++i) out[first + i] = valid[i] && packet.tfar[i] < 0.0f;
    }
  }
  bool any(const bool* flags) const {
    bool result = false;
    for (u32 i = 0; i < kLocal; ++i) result |= flags[i];
    return result;
  }
};

}  // namespace raywalk::embree
