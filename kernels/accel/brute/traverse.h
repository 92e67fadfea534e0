// The linear loop: the template for a new structure, and the oracle of the tests.
#pragma once
#include "kernels/query.h"

namespace raywalk::brute {

/// Tests every triangle of the scene. `blob` is the structure's blob (empty here). The ray is valid.
template <class Query, class Counter>
RW_FN void traverse(const u8* /*blob*/, SceneView scene, const Ray& /*ray*/, Query& query, Counter& counter) {
  const Corners* corners = scene.corners();
  for (u32 i = 0; i < scene.triangle_count(); ++i) {
    counter.test();
    if (query.test(corners[i])) return;
  }
}

}  // namespace raywalk::brute
