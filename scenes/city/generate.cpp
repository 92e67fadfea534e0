// The city: a square of blocks whose number grows with the triangles, on a plain six times as wide.
#include <algorithm>
#include <cmath>

#include "scenes/city/parts.h"
#include "scenes/generator.h"

namespace raywalk {
namespace {

using namespace city;

constexpr u64 kTrianglesPerBlock = 2500;
constexpr u64 kPlainTriangles = 200;
constexpr u64 kSquareShare = 8;  // the square in the middle has one in so many triangles more than another block

/// Blocks along one side: odd, so that there is one in the middle.
u64 blocks_for(u64 triangles) {
  const u64 most = (triangles - triangles / kSquareShare - kPlainTriangles) / kTrianglesPerBlock;
  const u64 side = static_cast<u64>(std::sqrt(static_cast<double>(most)));
  return std::clamp<u64>(side % 2 ? side : side - 1, 3, 61);
}

Pieces block(i32 column, i32 row) {
  Pieces pieces;
  Random random(static_cast<u32>(column * 7919 + row * 104729));
  const Vec3 centre = {kPitch * static_cast<float>(column), 0.0f, kPitch * static_cast<float>(row)};
  add_box(pieces, Placement::at(centre), {-kHalfBlock, 0.0f, -kHalfBlock}, {kHalfBlock, kKerb, kHalfBlock}, kPavement,
          kFlat);
  add_street(pieces, centre, random);
  if (column == 0 && row == 0) {
    add_square(pieces, random);
    return pieces;
  }
  const float core = 1.0f / (1.0f + 0.10f * static_cast<float>(column * column + row * row));
  for (const float x : {-13.5f, 13.5f}) {
    for (const float z : {-13.5f, 13.5f}) add_building(pieces, centre + Vec3{x, 0.0f, z}, 12.5f, core, random);
  }
  return pieces;
}

void pour(TriangleSink& sink, u64 triangles) {
  const i32 side = static_cast<i32>(blocks_for(triangles));
  const u64 blocks = static_cast<u64>(side) * static_cast<u64>(side);
  const float reach = 3.0f * kPitch * static_cast<float>(side);
  Pieces plain;
  add_quad(plain, {-reach, 0.0f, reach}, {2.0f * reach, 0.0f, 0.0f}, {0.0f, 0.0f, -2.0f * reach}, kAsphalt, 1.0);
  plain.add_to(sink, kPlainTriangles);

  const u64 for_square = triangles / kSquareShare;
  u64 left = triangles - kPlainTriangles - for_square;
  u64 done = 0;
  for (i32 row = -side / 2; row <= side / 2; ++row) {
    for (i32 column = -side / 2; column <= side / 2; ++column) {
      const u64 share = left / (blocks - done);
      block(column, row).add_to(sink, share + (row == 0 && column == 0 ? for_square : 0));
      left -= share;
      ++done;
    }
  }
}

}  // namespace

extern const Generator k_city_generator;
const Generator k_city_generator = {"city", 30'000, pour};

}  // namespace raywalk
