// Buildings: one to three tiers with window bands or window strips, and something on the roof.
#include "scenes/city/parts.h"

namespace raywalk::city {
namespace {

constexpr float kStorey = 3.6f;
constexpr float kProud = 0.06f;  // windows stand off the wall

/// One window on each of the four sides: `along` is its middle on the wall, `half` half its width.
void add_windows(Pieces& pieces, Vec3 at, float half_x, float half_z, float along_x, float half_width_x, float along_z,
                 float half_width_z, float bottom, float top) {
  const Vec3 up = {0.0f, top - bottom, 0.0f};
  const Vec3 base = at + Vec3{0.0f, bottom, 0.0f};
  const float x = half_x + kProud, z = half_z + kProud;
  add_quad(pieces, base + Vec3{along_x - half_width_x, 0.0f, z}, {2.0f * half_width_x, 0.0f, 0.0f}, up, kWindow, kFlat);
  add_quad(pieces, base + Vec3{along_x + half_width_x, 0.0f, -z}, {-2.0f * half_width_x, 0.0f, 0.0f}, up, kWindow,
           kFlat);
  add_quad(pieces, base + Vec3{x, 0.0f, along_z + half_width_z}, {0.0f, 0.0f, -2.0f * half_width_z}, up, kWindow,
           kFlat);
  add_quad(pieces, base + Vec3{-x, 0.0f, along_z - half_width_z}, {0.0f, 0.0f, 2.0f * half_width_z}, up, kWindow,
           kFlat);
}

/// A window band a storey, at most ten.
void add_bands(Pieces& pieces, Vec3 at, float half_x, float half_z, float bottom, float top) {
  float storey = kStorey;
  while ((top - bottom) / storey > 10.0f) storey += kStorey;
  for (float y = bottom + 1.1f; y + 0.6f * storey < top; y += storey) {
    add_windows(pieces, at, half_x, half_z, 0.0f, 0.9f * half_x, 0.0f, 0.9f * half_z, y, y + 0.55f * storey);
  }
}

void add_strips(Pieces& pieces, Vec3 at, float half_x, float half_z, float bottom, float top) {
  constexpr int kStrips = 5;
  for (int i = 0; i < kStrips; ++i) {
    const float s = (2.0f * static_cast<float>(i) + 1.0f) / kStrips - 1.0f;
    add_windows(pieces, at, half_x, half_z, s * half_x, 0.12f * half_x, s * half_z, 0.12f * half_z, bottom + 1.0f,
                top - 1.0f);
  }
}

}  // namespace

void add_building(Pieces& pieces, Vec3 at, float half_lot, float core, Random& random) {
  const u32 wall = kConcrete + random.below(4);
  const bool bands = random.unit() < 0.55f;
  float half_x = half_lot * random.between(0.68f, 0.95f), half_z = half_lot * random.between(0.68f, 0.95f);
  const float total = 9.0f + 10.0f * random.unit() + core * random.between(20.0f, 120.0f);
  const int tiers = total > 50.0f ? 2 : 1;
  float bottom = kKerb;
  for (int tier = 0; tier < tiers; ++tier) {
    const float top = tiers == 2 && tier == 0 ? total * random.between(0.3f, 0.6f) : total;
    add_box(pieces, Placement::at(at), {-half_x, bottom, -half_z}, {half_x, top, half_z}, wall, kFlat);
    (bands ? add_bands : add_strips)(pieces, at, half_x, half_z, bottom, top);
    bottom = top;
    half_x *= 0.72f;
    half_z *= 0.72f;
  }
  const Placement roof = Placement::at(at + Vec3{random.between(-2.0f, 2.0f), bottom, random.between(-2.0f, 2.0f)});
  add_box(pieces, roof, {-2.2f, 0.0f, -1.6f}, {2.2f, 2.4f, 1.6f}, kRoof, kFlat);
  add_turned(pieces, roof.inner({0.0f, 2.4f, 0.0f}), {{0.07f, 0.0f}, {0.05f, 3.0f}, {0.02f, 6.0f}}, kMetal, kFlat);
}

}  // namespace raywalk::city
