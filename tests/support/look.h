// What one ray of a scene shows, by brute force.
#pragma once
#include "kernels/accel/traversals.h"
#include "kernels/blob_writer.h"
#include "kernels/shade/radiance.h"
#include "kernels/tracer.h"

namespace raywalk::test {

/// One pixel that looks from `eye` exactly at `target`.
inline FrameArgs towards(Vec3 eye, Vec3 target, Mode mode, u32 depth = 0) {
  return {{eye, target - eye, {0, 0, 0}, {0, 0, 0}}, 1, 1, mode, depth, kAllLights};
}

template <u32 kFeatures = kAllFeatures, class TracerT>
Vec3 look_with(TracerT& tracer, const Blob& scene, const FrameArgs& args) {
  static_assert(TracerT::kLocal == 1);
  const u32 zero = 0;
  const bool active = true;
  Vec3 color;
  radiance<kFeatures>(tracer, SceneView{scene.data()}, args, &zero, &zero, &active, &color);
  return color;
}

inline Vec3 look(const Blob& scene, Vec3 eye, Vec3 target, Mode mode, u32 depth = 0) {
  SingleTracer<Brute, NoCounter> tracer{SceneView{scene.data()}, nullptr};
  return look_with(tracer, scene, towards(eye, target, mode, depth));
}

inline float largest_difference(Vec3 a, Vec3 b) {
  return largest(magnitude(a - b));
}

}  // namespace raywalk::test
