// Light on its way from a lamp through whatever lets it pass: coloured shadows.
#pragma once
#include "kernels/shade/spawn.h"

namespace raywalk {

/// Surfaces that a shadow ray passes at most; one more and it counts as occluded.
constexpr u32 kMaxPanes = 16;

/// Multiplies `light[i]` by the transmission of each surface between the origin of rays[i] and the lamp, where rays[i]
/// ends at t = 1; it is zero behind an opaque one. The light goes straight on, since bent it would miss the lamp
/// (Whitted 1980). Done for the lanes of `wanted`, which is cleared; rays are overwritten.
template <class Spawn, class Tracer>
RW_FN void filter_light(Tracer& tracer, SceneView scene, Vec3 lamp, Ray* rays, bool* wanted, Vec3* light) {
  constexpr u32 kLocal = Tracer::kLocal;
  for (u32 passed = 0;; ++passed) {
    Hit hits[kLocal]{};
    tracer.closest(rays, wanted, hits);
    for (u32 i = 0; i < kLocal; ++i) {
      wanted[i] = wanted[i] && hits[i].id != kMiss;
      if (!wanted[i]) continue;
      const Surface s = surface_at<0>(scene, hits[i], rays[i].d, 0.0f);
      light[i] = passed < kMaxPanes ? light[i] * scene.materials()[s.material].transmission : Vec3{0, 0, 0};
      const Vec3 origin = Spawn::origin(s, rays[i].d);
      const Vec3 rest = lamp - origin;
      // A surface at the lamp itself may be left beyond the lamp.
      wanted[i] = largest(light[i]) > 0.0f && dot(rest, rays[i].d) > 0.0f;
      rays[i] = {origin, 0.0f, rest, 1.0f};
    }
    if (!tracer.any(wanted)) return;
  }
}

}  // namespace raywalk
