// Host only: runs a tracer over ray lists and over the pixels of a tile.
#pragma once
#include <algorithm>

#include "kernels/shade/radiance.h"

namespace raywalk {

/// Calls work(first ray of the group, active flags) for groups of kLocal rays.
template <u32 kLocal, class Work>
void for_groups(u64 count, Work work) {
  bool active[kLocal];
  for (u64 first = 0; first < count; first += kLocal) {
    for (u32 i = 0; i < kLocal; ++i) active[i] = first + i < count;
    work(first, active);
  }
}

/// The rays of one group, the missing ones of the last group left unset.
template <u32 kLocal>
void take(const Ray* rays, const bool* active, Ray* group) {
  for (u32 i = 0; i < kLocal; ++i)
    if (active[i]) group[i] = rays[i];
}

/// Closest hits of `count` rays.
template <class TracerT>
void closest_hits(TracerT tracer, const Ray* rays, u64 count, Hit* hits) {
  constexpr u32 kLocal = TracerT::kLocal;
  for_groups<kLocal>(count, [&](u64 first, const bool* active) {
    if (active[kLocal - 1]) {
      tracer.closest(rays + first, active, hits + first);
      return;
    }
    Ray group[kLocal]{};
    Hit found[kLocal]{};
    take<kLocal>(rays + first, active, group);
    tracer.closest(group, active, found);
    std::copy_n(found, count - first, hits + first);
  });
}

/// 1 where a ray is occluded.
template <class TracerT>
void any_hits(TracerT tracer, const Ray* rays, u64 count, u8* out) {
  constexpr u32 kLocal = TracerT::kLocal;
  for_groups<kLocal>(count, [&](u64 first, const bool* active) {
    Ray group[kLocal]{};
    bool found[kLocal];
    take<kLocal>(rays + first, active, group);
    tracer.occluded(group, active, found);
    for (u32 i = 0; i < kLocal && active[i]; ++i) out[first + i] = found[i];
  });
}

/// Pixels in groups of kLocal: as many at a time of a block of kBlockRays. sink(x, y, colour) takes them.
template <class Spawn, class TracerT, class Sink>
void shade_tile(TracerT& tracer, SceneView scene, const FrameArgs& args, Tile tile, Sink sink) {
  constexpr u32 kLocal = TracerT::kLocal;
  static_assert(kBlockRays % kLocal == 0);
  for (u32 by = tile.y0; by < tile.y1; by += kBlockSide) {
    for (u32 bx = tile.x0; bx < tile.x1; bx += kBlockSide) {
      for (u32 first = 0; first < kBlockRays; first += kLocal) {
        u32 x[kLocal], y[kLocal];
        bool active[kLocal];
        Vec3 color[kLocal];
        for (u32 i = 0; i < kLocal; ++i) {
          x[i] = bx + block_x(first + i);
          y[i] = by + block_y(first + i);
          active[i] = x[i] < tile.x1 && y[i] < tile.y1;
        }
        radiance<kAllFeatures, Spawn>(tracer, scene, args, x, y, active, color);
        for (u32 i = 0; i < kLocal; ++i)
          if (active[i]) sink(x[i], y[i], color[i]);
      }
    }
  }
}

}  // namespace raywalk
