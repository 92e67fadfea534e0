// Colours of a group of pixels: Phong, shadow rays and Whitted's recursion, over any tracer; names no structure.
// T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980.
#pragma once
#include "kernels/features.h"
#include "kernels/frame_request.h"
#include "kernels/shade/direct.h"
#include "kernels/shade/shadow.h"

namespace raywalk {

constexpr u32 kMaxBounces = 16;

/// A ray still to be followed and what it contributes. Depth first, at most one waits for each bounce.
struct PendingRay {
  Ray ray;
  Vec3 weight;
  u32 bounces_left;
};

/// Colours of `Tracer::kLocal` pixels (x[i], y[i]) of which `active` ones are wanted; others are left alone.
/// A tracer has kLocal, closest(rays, active, hits) and occluded(rays, active, occluded) over arrays of kLocal lanes,
/// and any(flags), true if a flag of any lane of the group is set.
/// Shadow rays end at any hit, but in Mode::whitted, in a scene with glass: there glass colours the light.
template <u32 kFeatures, class Spawn = ErrorBoundOffset, class Tracer>
RW_FN void radiance(Tracer& tracer, SceneView scene, const FrameArgs& args, const u32* x, const u32* y,
                    const bool* active, Vec3* color) {
  constexpr u32 kLocal = Tracer::kLocal;
  constexpr bool kSecondary = (kFeatures & (kFeatureReflection | kFeatureRefraction)) != 0;
  constexpr bool kGlass = (kFeatures & kFeatureRefraction) != 0;
  constexpr bool kTextured = (kFeatures & kFeatureTextures) != 0;
  const bool colored_shadows = kGlass && args.mode == Mode::whitted &&
                               (kCompiledForScene || (scene.header().features & kFeatureRefraction) != 0);

  Ray rays[kLocal];
  Vec3 weight[kLocal];
  float travelled[kLocal];  // from the eye to where each ray starts, then to where it ends
  const float spread = spread_of(args.camera);
  u32 bounces_left[kLocal];
  bool alive[kLocal];
  PendingRay pending[kSecondary ? kLocal : 1][kSecondary ? kMaxBounces + 1 : 1];
  float pending_travelled[kSecondary && kTextured ? kLocal : 1][kSecondary && kTextured ? kMaxBounces + 1 : 1];
  u32 waiting[kLocal];
  for (u32 i = 0; i < kLocal; ++i) {
    alive[i] = active[i];
    waiting[i] = 0;
    rays[i] = primary_ray(args.camera, x[i], y[i]);
    weight[i] = {1, 1, 1};
    travelled[i] = 0.0f;
    bounces_left[i] = args.mode == Mode::whitted ? smaller(args.depth, kMaxBounces) : 0u;
    if (active[i]) color[i] = {0, 0, 0};
  }

  if (args.mode == Mode::primary) {
    Hit hits[kLocal]{};
    tracer.closest(rays, alive, hits);
    const u32 lights = lights_of<kFeatures>(scene, args.lights);  // late, so that it takes no register of the traversal
    for (u32 i = 0; i < kLocal; ++i)
      if (alive[i]) color[i] = unshadowed<kFeatures>(scene, hits[i], rays[i].d, spread, lights);
    return;
  }

  for (;;) {
    Hit hits[kLocal]{};
    tracer.closest(rays, alive, hits);

    Surface surfaces[kLocal]{};
    bool lit[kLocal]{};
    for (u32 i = 0; i < kLocal; ++i) {
      lit[i] = alive[i] && hits[i].id != kMiss;
      if (!alive[i]) continue;
      if (!lit[i]) {
        color[i] = color[i] + weight[i] * scene.header().background;
        continue;
      }
      if constexpr (kTextured) travelled[i] += hits[i].t;
      surfaces[i] = surface_at<kFeatures>(scene, hits[i], rays[i].d, spread * travelled[i]);
      color[i] = color[i] + weight[i] * unlit<kFeatures>(scene, surfaces[i].material, surfaces[i].tint);
    }

    const u32 lights = lights_of<kFeatures>(scene, args.lights);
    for (u32 l = 0; l < lights; ++l) {
      const Light& light = scene.lights()[l];
      Vec3 contribution[kLocal]{};
      bool wanted[kLocal];
      Ray shadow[kLocal]{};
      for (u32 i = 0; i < kLocal; ++i) {
        wanted[i] = false;
        if (!lit[i]) continue;
        const Surface& s = surfaces[i];
        const Vec3 to_light = light.position - s.position;
        contribution[i] =
            phong<(kFeatures & kFeatureSpecular) != 0>(phong_terms<kFeatures>(scene, s.material, s.tint),
                                                       light.intensity, s.normal, normalized(to_light), rays[i].d);
        wanted[i] = largest(contribution[i]) > 0.0f;
        if (wanted[i]) {
          const Vec3 origin = Spawn::origin(s, to_light);
          shadow[i] = {origin, 0.0f, light.position - origin, 1.0f};
        }
      }
      if (!tracer.any(wanted)) continue;
      if constexpr (kGlass) {
        if (colored_shadows) {
          filter_light<Spawn>(tracer, scene, light.position, shadow, wanted, contribution);
          for (u32 i = 0; i < kLocal; ++i)
            if (largest(contribution[i]) > 0.0f) color[i] = color[i] + weight[i] * contribution[i];
          continue;
        }
      }
      bool occluded[kLocal];
      tracer.occluded(shadow, wanted, occluded);
      for (u32 i = 0; i < kLocal; ++i)
        if (wanted[i] && !occluded[i]) color[i] = color[i] + weight[i] * contribution[i];
    }

    if (!kSecondary || args.mode != Mode::whitted) return;
    for (u32 i = 0; i < kLocal; ++i) {
      if (!alive[i]) continue;
      if (lit[i] && bounces_left[i] > 0) {
        const Surface& s = surfaces[i];
        const Material& m = scene.materials()[s.material];
        // Vertex normals may lean away from the ray, or send its mirror image into the solid or the refracted one back
        // out: then the triangle's own.
        const Vec3 plane = s.front ? s.geometric_normal : -s.geometric_normal;
        const Vec3 n = dot(rays[i].d, s.normal) < 0.0f ? s.normal : plane;
        Vec3 mirrored = m.reflection;
        const auto follow = [&](Vec3 d, Vec3 part) {
          if constexpr (kTextured) pending_travelled[i][waiting[i]] = travelled[i];
          pending[i][waiting[i]++] = {{Spawn::origin(s, d), 0.0f, d, kMaxFloat}, weight[i] * part, bounces_left[i] - 1};
        };
        if (kGlass && largest(m.transmission) > 0.0f) {
          const float eta = s.front ? reciprocal(m.ior) : m.ior;
          Vec3 d;
          bool passes = refracted(rays[i].d, n, eta, d);
          if (passes && dot(d, plane) > 0.0f) passes = refracted(rays[i].d, plane, eta, d);
          if (passes) {
            follow(d, m.transmission);
          } else {
            mirrored = mirrored + m.transmission;  // total reflection
          }
        }
        if (largest(mirrored) > 0.0f) {
          const Vec3 mirror = reflected(rays[i].d, n);
          follow(normalized(dot(mirror, plane) > 0.0f ? mirror : reflected(rays[i].d, plane)), mirrored);
        }
      }
      alive[i] = waiting[i] > 0;
      if (alive[i]) {
        const PendingRay& next = pending[i][--waiting[i]];
        rays[i] = next.ray;
        weight[i] = next.weight;
        if constexpr (kTextured) travelled[i] = pending_travelled[i][waiting[i]];
        bounces_left[i] = next.bounces_left;
      }
    }
    if (!tracer.any(alive)) return;
  }
}

}  // namespace raywalk
