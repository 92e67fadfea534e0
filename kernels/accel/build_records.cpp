// Host only: makes transforms of a scene's triangles.
#include "kernels/accel/build_records.h"

#include <tbb/parallel_for.h>

namespace raywalk {

Option triangles_option() {
  return {.name = "triangles",
          .help =
              "what triangle tests read: corners, or precomputed transforms for the intersector baldwin-weber, "
              "48 bytes a triangle each",
          .integer = true,
          .choices = {"corners", "transforms"}};
}

TriangleRecords triangles_of(const OptionValues& options) {
  return static_cast<TriangleRecords>(static_cast<u32>(options.find("triangles")->second));
}

void write_transforms(SceneView scene, std::span<Transform> transforms) {
  tbb::parallel_for(size_t{0}, transforms.size(), [&](size_t i) { transforms[i] = transform_of(scene.corners()[i]); });
}

}  // namespace raywalk
