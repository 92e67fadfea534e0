// The organic object, closed, in the place and of the size of the Stanford bunny (metres).
#include "scenes/common/organic_surface.h"
#include "scenes/generator.h"

namespace raywalk {
namespace {

constexpr Vec3 kCentre{-0.0168f, 0.1000f, -0.0015f};
constexpr Vec3 kScale{0.0775f, 0.0775f, 0.0700f};

SurfacePoint placed(Vec3 direction, float spacing) {
  const SurfacePoint p = organic_surface(direction, spacing);
  const Vec3 inverse = {1.0f / kScale.x, 1.0f / kScale.y, 1.0f / kScale.z};
  return {kCentre + kScale * p.position, normalized(inverse * p.normal)};
}

void pour(TriangleSink& sink, u64 triangles) {
  add_ball(sink, placed, 0, triangles / 2 * 2);
  if (triangles % 2 == 0) return;
  // A closed surface has an even number of triangles. The odd one lies in the core, where no ray from outside comes.
  const Vec3 normal = {0.0f, 1.0f, 0.0f};
  const u32 a = sink.add_vertex(kCentre + Vec3{0.0f, 0.0f, 1e-3f}, normal);
  sink.add_vertex(kCentre + Vec3{1e-3f, 0.0f, -1e-3f}, normal);
  sink.add_vertex(kCentre + Vec3{-1e-3f, 0.0f, -1e-3f}, normal);
  sink.add_triangle({a, a + 1, a + 2, 0});
}

}  // namespace

extern const Generator k_organic_generator;
const Generator k_organic_generator = {"organic", kLeastBallTriangles, pour};

}  // namespace raywalk
