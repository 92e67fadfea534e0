// Light straight from the lamps, without shadows: what Mode::primary shows.
#pragma once
#include "kernels/features.h"
#include "kernels/shade/phong.h"
#include "kernels/shade/surface.h"

namespace raywalk {

/// How many lights shine, when `asked` are asked for.
template <u32 kFeatures>
RW_FN u32 lights_of(SceneView scene, u32 asked) {
  return smaller(scene.light_count(), (kFeatures & kFeatureManyLights) ? asked : smaller(asked, 1u));
}

/// The local model's terms at a surface.
template <u32 kFeatures>
RW_FN PhongTerms phong_terms(SceneView scene, u32 material, Vec3 tint) {
  const Material& m = scene.materials()[material];
  PhongTerms terms{m.diffuse, m.specular, m.shininess};
  if constexpr ((kFeatures & kFeatureTextures) != 0) terms.diffuse = terms.diffuse * tint;
  return terms;
}

/// What a surface shows without any lamp: its share of the ambient light and what it emits.
template <u32 kFeatures>
RW_FN Vec3 unlit(SceneView scene, u32 material, Vec3 tint) {
  const Material& m = scene.materials()[material];
  Vec3 ambient = m.ambient * scene.header().ambient;
  if constexpr ((kFeatures & kFeatureTextures) != 0) ambient = ambient * tint;
  return ambient + m.emission;
}

/// What a primary ray of unit direction `d` shows: each of the first `lights` lamps shines on everything. `spread` is
/// the width of a pixel at distance 1.
template <u32 kFeatures>
RW_FN Vec3 unshadowed(SceneView scene, const Hit& hit, Vec3 d, float spread, u32 lights) {
  if (hit.id == kMiss) return scene.header().background;
  const Surface s = surface_at<kFeatures>(scene, hit, d, spread * hit.t);
  const PhongTerms terms = phong_terms<kFeatures>(scene, s.material, s.tint);
  Vec3 sum = unlit<kFeatures>(scene, s.material, s.tint);
  for (u32 l = 0; l < lights; ++l) {
    const Light& light = scene.lights()[l];
    sum = sum + phong<(kFeatures & kFeatureSpecular) != 0>(terms, light.intensity, s.normal,
                                                           normalized(light.position - s.position), d);
  }
  return sum;
}

}  // namespace raywalk
