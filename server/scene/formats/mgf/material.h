// MGF's materials, which are physical, and what becomes of them in the model of Phong and Whitted.
#pragma once
#include "kernels/scene_view.h"
#include "server/scene/formats/mgf/color.h"

namespace raywalk {

struct MgfMaterial {
  /// A share of the light (lm/m2 if emitted) and its colour.
  struct Term {
    double amount = 0.0;
    MgfColor color{};
    double roughness = 0.0;
  };
  Term diffuse, translucent, emitted, specular, transparent;  // rd, td, ed, rs, ts
  double ior = 1.0;
  bool two_sided = true;
  u32 index = kNotAdded;  // among the scene's materials, as it is now

  static constexpr u32 kNotAdded = 0xffffffffu;
};

/// See the table in server/scene/formats/README.md.
Material phong_material(const MgfMaterial& material);

}  // namespace raywalk
