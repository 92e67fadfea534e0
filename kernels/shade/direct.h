// Light straight from the lamps, without shadows: what Mode::primary shows.
#pragma once
#include "kernels/features.h"
#include "kernels/shade/phong.h"
#include "kernels/shade/surface.h"

namespace raywalk {

/// Lights that the features allow.
template <u32 kFeatures>
RW_FN u32 lights_of(SceneView scene) {
  return (kFeatures & kFeatureManyLights) ? scene.light_count() : smaller(scene.light_count(), 1u);
}

RW_FN PhongTerms phong_terms(SceneView scene, u32 material) {
  const Material& m = scene.materials()[material];
  return {m.diffuse, m.specular, m.shininess};
}

RW_FN Vec3 ambient_of(SceneView scene, u32 material) {
  return scene.materials()[material].ambient * scene.header().ambient;
}

/// What a primary ray of unit direction `d` shows: every lamp shines on everything.
template <u32 kFeatures>
RW_FN Vec3 unshadowed(SceneView scene, const Hit& hit, Vec3 d) {
  if (hit.id == kMiss) return scene.header().background;
  const Surface s = surface_at<(kFeatures & kFeatureNormals) != 0>(scene, hit, d);
  const PhongTerms terms = phong_terms(scene, s.material);
  Vec3 sum = ambient_of(scene, s.material);
  for (u32 l = 0; l < lights_of<kFeatures>(scene); ++l) {
    const Light& light = scene.lights()[l];
    sum = sum + phong<(kFeatures & kFeatureSpecular) != 0>(terms, light.intensity, s.normal,
                                                           normalized(light.position - s.position), d);
  }
  return sum;
}

}  // namespace raywalk
