// Host only: `unshadowed` for eight hits at once. The same functions, called in loops over separate arrays for each
// component, which a compiler turns into vector instructions; so the bits are the same as one by one.
#pragma once
#include "kernels/shade/direct.h"

namespace raywalk {

constexpr u32 kBatch = 8;

struct Vec3Batch {
  alignas(32) float x[kBatch], y[kBatch], z[kBatch];
  void set(u32 i, Vec3 v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
  Vec3 get(u32 i) const { return {x[i], y[i], z[i]}; }
};

/// Eight hits, none of them a miss, with the directions of their rays.
struct HitBatch {
  alignas(32) u32 id[kBatch];
  alignas(32) float t[kBatch];
  alignas(32) float u[kBatch];
  alignas(32) float v[kBatch];
  Vec3Batch d;
};

/// colors.get(i) == unshadowed(scene, hit i, d i, spread, lights).
void unshadowed_batch(SceneView scene, const HitBatch& batch, float spread, u32 lights, Vec3Batch& colors);

}  // namespace raywalk
