// Uniform triangle soup: small triangles of all directions, spread evenly over a cube of side 2.
#include <cmath>

#include "scenes/common/exact_math.h"
#include "scenes/generator.h"

namespace raywalk {
namespace {

constexpr u32 kMaterials = 6;

float cube_root(float a) {
  float x = a > 1.0f ? a : 1.0f;
  // Newton's iteration instead of std::cbrt, whose last bit differs between libraries.
  for (int i = 0; i < 64; ++i) x = (2.0f * x + a / (x * x)) / 3.0f;
  return x;
}

Vec3 random_direction(Random& random) {
  while (true) {
    const Vec3 p = {random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f)};
    const float l = length(p);
    if (l > 0.1f && l <= 1.0f) return p * (1.0f / l);
  }
}

void pour(TriangleSink& sink, u64 triangles) {
  Random random(2009);
  // The triangles' size follows their distance, so that the density of the soup is the same at any count.
  const float size = 1.6f / cube_root(static_cast<float>(triangles));
  for (u64 i = 0; i < triangles; ++i) {
    const Vec3 centre = {random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f)};
    const Vec3 normal = random_direction(random);
    const Vec3 side = normalized(cross(normal, random_direction(random)));
    const Vec3 across = cross(normal, side);
    const float radius = size * random.between(0.4f, 1.0f);
    // Corners of an equilateral triangle.
    const u32 a = sink.add_vertex(centre + radius * side, normal);
    const u32 b = sink.add_vertex(centre + radius * (-0.5f * side + 0.8660254f * across), normal);
    const u32 c = sink.add_vertex(centre + radius * (-0.5f * side - 0.8660254f * across), normal);
    sink.add_triangle({a, b, c, random.below(kMaterials)});
  }
}

}  // namespace

extern const Generator k_soup_generator;
const Generator k_soup_generator = {"soup", 1, pour};

}  // namespace raywalk
