// Shapes and aims at random.
#include "tests/accuracy/at_scale/boxed_pair.h"

#include <algorithm>
#include <cmath>

#include "kernels/accel/bvh/compress.h"
#include "server/scene/degenerate.h"

namespace raywalk::at_scale {
namespace {

using accuracy::Random;

constexpr Vec3 kMinus{-1, -1, -1}, kPlus{1, 1, 1};

float power_of_ten(Random& random, float lo, float hi) {
  return std::pow(10.0f, random.uniform(lo, hi));
}

float& at(Vec3& v, u32 axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

Vec3 signed_zeros(Random& random) {
  const auto zero = [&] { return random.below(2) != 0 ? 0.0f : -0.0f; };
  const float x = zero(), y = zero(), z = zero();
  return {x, y, z};
}

/// About 1 across, around the origin.
Corners random_shape(Random& random) {
  Vec3 p[3];
  for (Vec3& corner : p) corner = random.in_box(kMinus, kPlus);
  switch (random.below(6)) {
    case 0: {  // in the plane of an axis
      const u32 axis = random.below(3);
      at(p[1], axis) = at(p[2], axis) = at(p[0], axis);
      break;
    }
    case 1: {  // nearly so
      const u32 axis = random.below(3);
      for (u32 i = 1; i < 3; ++i) at(p[i], axis) = p[0][axis] + random.uniform(-1, 1) * power_of_ten(random, -7, -2);
      break;
    }
    case 2:  // a short edge
      p[1] = p[0] + random.direction() * power_of_ten(random, -6, -1);
      break;
    case 3:  // nearly a line
      p[2] = p[0] + (p[1] - p[0]) * random.uniform() + random.direction() * power_of_ten(random, -6, -1);
      break;
    case 4:  // on a lattice: edges along axes
      for (Vec3& corner : p)
        corner = {std::nearbyint(2 * corner.x), std::nearbyint(2 * corner.y), std::nearbyint(2 * corner.z)};
      break;
    default:
      break;
  }
  return accuracy::triangle(p[0], p[1], p[2]);
}

accuracy::Mesh random_triangles(Random& random) {
  const float size = power_of_ten(random, -6, 6), other = size * power_of_ten(random, -3, 3);
  const bool centred = random.below(4) == 0;
  const Vec3 centre = centred ? Vec3{0, 0, 0} : random.direction() * (size * power_of_ten(random, -2, 6));
  const Vec3 away = random.direction() * (size * power_of_ten(random, -2, 5));
  accuracy::Mesh both = accuracy::transformed({random_shape(random)}, size, centre);
  accuracy::append(both, accuracy::transformed({random_shape(random)}, other, centre + away));
  return both;
}

Vec3 vertex(const Corners& t, u32 i) {
  return i == 0 ? t.a : i == 1 ? t.b : t.c;
}

Vec3 point_on_box(const Box& box, Random& random) {
  const u32 loose = random.below(3);  // coordinates that are of no plane: none at a corner, one on an edge
  const u32 first = random.below(3);
  Vec3 point;
  for (u32 i = 0; i < 3; ++i) {
    const u32 axis = (first + i) % 3;
    const float lo = box.lo[axis], hi = box.hi[axis];
    at(point, axis) = i < loose ? random.uniform(lo, hi) : random.below(2) != 0 ? lo : hi;
  }
  return point;
}

Vec3 random_target(const Corners& t, Random& random) {
  const u32 corner = random.below(3);
  const Vec3 from = vertex(t, corner), to = vertex(t, (corner + 1) % 3), third = vertex(t, (corner + 2) % 3);
  switch (random.below(8)) {
    case 0:
    case 1:
      return from;
    case 2:
    case 3: {
      const float along = random.uniform();
      return from * (1.0f - along) + to * along;
    }
    case 4:
      return from * 0.5f + to * 0.5f;
    case 5:
    case 6: {
      const float u = random.uniform(), v = random.uniform(0.0f, 1.0f - u);
      return from * (1.0f - u - v) + to * u + third * v;
    }
    default:
      return point_on_box(bounds_of(t), random);
  }
}

/// Along an axis the other components are zeros, or tiny against it.
Vec3 random_direction(Random& random) {
  if (random.below(3) == 0) return random.direction();
  Vec3 d = signed_zeros(random);
  const u32 axis = random.below(3);
  at(d, axis) = random.below(2) != 0 ? 1.0f : -1.0f;
  for (u32 i = 1; i < 3; ++i)
    if (random.below(3) == 0) at(d, (axis + i) % 3) = random.uniform(-1, 1) * power_of_ten(random, -12, -1);
  return d;
}

}  // namespace

BoxedPair random_pair(Random& random) {
  accuracy::Mesh mesh = random_triangles(random);
  while (std::ranges::any_of(mesh, is_degenerate)) mesh = random_triangles(random);  // rounding may leave no area
  const Blob scene = accuracy::make_scene(mesh);

  BoxedPair pair{bvh::build(accuracy::view_of(scene), {.max_leaf = 1}), {}, {}, {}, {}};
  const Corners* in_leaves = data_of(pair.built.blob.data(), pair.header().triangles<Corners>());
  for (u32 side = 0; side < 2; ++side) {
    pair.triangles[side] = in_leaves[bvh::leaf_first(pair.node().child[side])];
    pair.sizes[side] = largest(bounds_of(pair.triangles[side]).extent());
  }
  pair.half = bvh::compressed_to_halves(pair.node(), pair.header().unit);
  pair.byte = bvh::compressed_to_bytes(pair.node());
  return pair;
}

Ray random_ray(const BoxedPair& pair, u32 side, Random& random) {
  const Vec3 target = random_target(pair.triangles[side], random);
  const float distance = random.below(8) == 0 ? 0.0f : pair.sizes[side] * power_of_ten(random, -3, 4);
  const Vec3 along = random_direction(random), origin = target - along * distance;
  const bool exactly_along = random.below(2) != 0 || !(largest(magnitude(target - origin)) > 0.0f);
  const Vec3 d = exactly_along ? along * power_of_ten(random, -3, 3) : target - origin;
  const float tmin = random.below(8) == 0 ? -accuracy::kFarAway : 0.0f;
  return {origin, tmin, d, accuracy::kFarAway};
}

}  // namespace raywalk::at_scale
