// Corners sorted by position.
#include "server/accuracy/sweep/vertex_fans.h"

#include <algorithm>
#include <tuple>

namespace raywalk::accuracy {
namespace {

/// Cosine between ray and plane below which a triangle may turn when the arithmetic rounds.
constexpr float kEdgeOn = 1e-3f;

bool before(Vec3 a, Vec3 b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace

VertexFans::VertexFans(SceneView scene) : scene_(scene) {
  corners_.reserve(3ull * scene.triangle_count());
  for (u32 id = 0; id < scene.triangle_count(); ++id) {
    if (!is_finite(scene.corners()[id])) continue;
    for (u32 k = 0; k < 3; ++k) corners_.push_back(3 * id + k);
  }
  std::ranges::sort(corners_, [this](u32 a, u32 b) { return before(position(a), position(b)); });
}

Vec3 VertexFans::position(u32 corner) const {
  const Corners& t = scene_.corners()[corner / 3];
  return corner % 3 == 0 ? t.a : corner % 3 == 1 ? t.b : t.c;
}

bool VertexFans::face_alike(Vec3 p, Vec3 d) const {
  const Vec3 along = normalized(d);
  const auto first = std::ranges::lower_bound(corners_, p, before, [this](u32 corner) { return position(corner); });
  bool front = false, back = false;
  for (auto corner = first; corner != corners_.end() && position(*corner) == p; ++corner) {
    const Corners& t = scene_.corners()[*corner / 3];
    const float facing = dot(along, normalized(cross(t.b - t.a, t.c - t.a)));
    front |= facing < kEdgeOn;
    back |= facing > -kEdgeOn;
  }
  return front != back;
}

}  // namespace raywalk::accuracy
