// The linear loop: the template for a new structure, and the oracle of the tests.
#pragma once
#include "kernels/accel/records.h"

namespace raywalk::brute {

/// Of a structure that holds transforms; one of corners is empty.
struct Header {
  Slice<Transform> transforms;  // by id
};

/// Tests every triangle of the scene. The ray is valid.
template <class Query, class Counter>
RW_FN void traverse(const u8* blob, SceneView scene, const Ray& /*ray*/, Query& query, Counter& counter) {
  const auto* records = records_by_id<Query, Header>(blob, scene);
  for (u32 i = 0; i < scene.triangle_count(); ++i) {
    counter.test();
    if (query.test(records[i])) return;
  }
}

}  // namespace raywalk::brute
