// What a scene needs of the shading code, as a bit mask. Feature code is a no-op on data that lacks the feature.
#pragma once
#include "kernels/platform.h"

namespace raywalk {

enum Feature : u32 {
  kFeatureNormals = 1u << 0,     // interpolated vertex normals
  kFeatureSpecular = 1u << 1,    // Phong highlights
  kFeatureReflection = 1u << 2,  // mirrors
  kFeatureRefraction = 1u << 3,  // glass
  kFeatureManyLights = 1u << 4,  // more than one light
  kFeatureTextures = 1u << 5,
};
constexpr u32 kAllFeatures = (1u << 6) - 1;

}  // namespace raywalk
