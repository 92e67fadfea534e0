// The kind "brute": an empty blob, since the linear loop reads the scene itself.
#include "kernels/accel/brute/kind.h"

namespace raywalk::brute {

const Kind& kind() {
  static const Kind kKind{
      "brute", "no structure: every ray meets every triangle", {}, [](SceneView scene, const OptionValues&) {
        BuiltStructure built{Blob(0), {}};
        built.stats.references = scene.triangle_count();
        return built;
      }};
  return kKind;
}

}  // namespace raywalk::brute
