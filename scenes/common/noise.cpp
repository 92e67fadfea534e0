// Perlin's gradient noise with hashed gradients towards the edges of a cube.
#include "scenes/common/noise.h"

#include <cmath>

#include "scenes/common/exact_math.h"

namespace raywalk {
namespace {

float gradient(i32 x, i32 y, i32 z, Vec3 d) {
  const u32 h = hashed(static_cast<u32>(x) * 0x8da6b343u ^ static_cast<u32>(y) * 0xd8163841u ^
                       static_cast<u32>(z) * 0xcb1ab31fu) &
                15u;
  const float u = h < 8 ? d.x : d.y;
  const float v = h < 4 ? d.y : (h == 12 || h == 14) ? d.x : d.z;
  return ((h & 1u) ? -u : u) + ((h & 2u) ? -v : v);
}

float fade(float t) {
  return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

float mix(float a, float b, float w) {
  return a + w * (b - a);
}

}  // namespace

float noise(Vec3 p) {
  const Vec3 cell = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const Vec3 d = p - cell;
  const i32 x = static_cast<i32>(cell.x), y = static_cast<i32>(cell.y), z = static_cast<i32>(cell.z);
  float corner[8];
  for (i32 i = 0; i < 8; ++i) {
    const i32 dx = i & 1, dy = i >> 1 & 1, dz = i >> 2;
    corner[i] = gradient(x + dx, y + dy, z + dz,
                         d - Vec3{static_cast<float>(dx), static_cast<float>(dy), static_cast<float>(dz)});
  }
  const float u = fade(d.x), v = fade(d.y), w = fade(d.z);
  return mix(mix(mix(corner[0], corner[1], u), mix(corner[2], corner[3], u), v),
             mix(mix(corner[4], corner[5], u), mix(corner[6], corner[7], u), v), w);
}

float fractal_noise(Vec3 p, int octaves) {
  float sum = 0.0f;
  float height = 1.0f;
  for (int i = 0; i < octaves; ++i) {
    sum += height * noise(p);
    // The offset keeps the lattice points of the octaves apart, where all would be zero.
    p = 2.0f * p + Vec3{17.3f, 5.7f, 11.1f};
    height *= 0.5f;
  }
  return sum;
}

}  // namespace raywalk
