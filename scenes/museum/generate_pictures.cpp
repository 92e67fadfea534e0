// Paintings of three kinds in gilded frames, painted in flat layers, and a tall mirror.
#include <vector>

#include "scenes/common/noise.h"
#include "scenes/museum/parts.h"

namespace raywalk::museum {
namespace {

constexpr float kLayer = 0.0015f;  // between two layers of paint

/// A canvas that hangs on a wall: x to the right and y up from its lower left corner, z out of the wall.
struct Canvas {
  Placement place;
  float width, height;

  Vec3 point(float x, float y, int layer) const {
    return place.point({x, y, 0.03f + kLayer * static_cast<float>(layer)});
  }
  void rectangle(Pieces& pieces, float x, float y, float w, float h, int layer, u32 material) const {
    add_quad(pieces, point(x, y, layer), place.direction({w, 0.0f, 0.0f}), {0.0f, h, 0.0f}, material, kFlat);
  }
  void disc(Pieces& pieces, float x, float y, float radius, int layer, u32 material) const {
    add_disc(pieces, point(x, y, layer), place.direction({0.0f, 0.0f, 1.0f}), radius, material, 1.5 * kFine);
  }
};

/// Four bevelled bars around the canvas.
void add_frame(Pieces& pieces, const Canvas& c, float bar, u32 material) {
  const auto side = [&](Vec3 a, Vec3 b, Vec3 inner_a, Vec3 inner_b) {
    const Vec3 crest = {0.0f, 0.0f, 0.07f}, back = {0.0f, 0.0f, 0.025f};
    const Vec3 outer[] = {a, b, b + crest, a + crest}, slope[] = {a + crest, b + crest, inner_b + back, inner_a + back};
    for (const Vec3* corner : {outer, slope}) {
      const Vec3 p = c.place.point(corner[0]);
      const Vec3 ab = c.place.point(corner[1]) - p, ad = c.place.point(corner[3]) - p;
      const Vec3 bc = c.place.point(corner[2]) - c.place.point(corner[1]);
      const Vec3 normal = normalized(cross(ab, ad));
      pieces.patch(
          [=](float u, float v) {
            return SurfacePoint{p + u * ab + v * ((1.0f - u) * ad + u * bc), normal};
          },
          8.0f, material, kFlat * length(ab) * length(ad));
    }
  };
  const float w = c.width, h = c.height, f = bar;
  side({-f, -f, 0.0f}, {w + f, -f, 0.0f}, {0.0f, 0.0f, 0.0f}, {w, 0.0f, 0.0f});
  side({w + f, -f, 0.0f}, {w + f, h + f, 0.0f}, {w, 0.0f, 0.0f}, {w, h, 0.0f});
  side({w + f, h + f, 0.0f}, {-f, h + f, 0.0f}, {w, h, 0.0f}, {0.0f, h, 0.0f});
  side({-f, h + f, 0.0f}, {-f, -f, 0.0f}, {0.0f, h, 0.0f}, {0.0f, 0.0f, 0.0f});
}

void paint_landscape(Pieces& pieces, const Canvas& c, float seed) {
  c.rectangle(pieces, 0.0f, 0.0f, c.width, c.height, 0, kSky);
  c.rectangle(pieces, 0.0f, 0.0f, c.width, 0.62f * c.height, 1, kPaleSky);
  c.disc(pieces, c.width * (0.28f + 0.4f * magnitude(noise({seed, 0.5f, 0.3f}))), 0.66f * c.height, 0.11f * c.height, 2,
         kSun);
  const u32 hills[] = {kFarHill, kHill, kMeadow};
  for (int i = 0; i < 3; ++i) {
    const float level = 0.52f - 0.17f * static_cast<float>(i), swing = 0.20f - 0.04f * static_cast<float>(i);
    const auto shape = [=](float u, float v) {
      const Vec3 p = {2.6f * u * (1.0f + 0.3f * static_cast<float>(i)) + 11.0f * seed, seed,
                      3.7f * static_cast<float>(i)};
      const float top = c.height * (level + swing * noise(p));
      return SurfacePoint{c.point(u * c.width, v * top, 3 + i), c.place.direction({0.0f, 0.0f, 1.0f})};
    };
    pieces.patch(shape, 30.0f, hills[i], 50.0 * kFlat * c.width * c.height);
  }
}

/// Bars and fields of plain colour.
void paint_fields(Pieces& pieces, const Canvas& c, u32 seed) {
  c.rectangle(pieces, 0.0f, 0.0f, c.width, c.height, 0, kCanvas);
  Random random(seed);
  const float xs[] = {0.0f, random.between(0.16f, 0.3f), random.between(0.55f, 0.75f), 1.0f};
  const float ys[] = {0.0f, random.between(0.15f, 0.3f), random.between(0.5f, 0.7f), 1.0f};
  const u32 colours[] = {kRed, kBlue, kYellow, kCanvas, kBlack};
  for (u32 i = 0; i < 4; ++i) {
    const u32 column = (i + random.below(2)) % 3, row = (2 * i + random.below(2)) % 3;
    c.rectangle(pieces, xs[column] * c.width, ys[row] * c.height, (xs[column + 1] - xs[column]) * c.width,
                (ys[row + 1] - ys[row]) * c.height, 1 + static_cast<int>(i), colours[i]);
  }
  const float bar = 0.022f * c.height;
  for (int i = 1; i < 3; ++i) {
    c.rectangle(pieces, xs[i] * c.width - 0.5f * bar, 0.0f, bar, c.height, 6, kBlack);
    c.rectangle(pieces, 0.0f, ys[i] * c.height - 0.5f * bar, c.width, bar, 7, kBlack);
  }
}

/// Discs inside discs.
void paint_circles(Pieces& pieces, const Canvas& c, u32 seed) {
  c.rectangle(pieces, 0.0f, 0.0f, c.width, c.height, 0, kPaleSky);
  Random random(seed);
  const u32 colours[] = {kRed, kCanvas, kBlue, kYellow, kBlack, kSun, kMeadow};
  const int columns = c.width > c.height ? 3 : 2, rows = c.width > c.height ? 2 : 3;
  const float cell = smaller(c.width / static_cast<float>(columns), c.height / static_cast<float>(rows));
  for (int i = 0; i < columns * rows; ++i) {
    const float x = (static_cast<float>(i % columns) + 0.5f) * c.width / static_cast<float>(columns);
    const float y = (static_cast<float>(i / columns) + 0.5f) * c.height / static_cast<float>(rows);
    u32 colour = random.below(7);
    for (int ring = 0; ring < 3; ++ring) {
      c.disc(pieces, x, y, cell * (0.45f - 0.14f * static_cast<float>(ring)), 1 + ring, colours[colour]);
      colour = (colour + 1 + random.below(5)) % 7;
    }
  }
}

}  // namespace

void add_pictures(Pieces& pieces) {
  constexpr float kLow = 1.25f;
  for (const float side : {-1.0f, 1.0f}) {
    for (int i = 0; i < 4; ++i) {
      const float z = kBay * (static_cast<float>(i) - 1.5f);
      const int kind = (i + (side > 0.0f ? 2 : 0)) % 3;
      const float width = kind == 1 ? 1.35f : 1.9f, height = kind == 1 ? 1.6f : 1.25f;
      const Placement place = Placement::at({side * kSideX, kLow, z - 0.5f * side * width}, side > 0.0f ? -0.25 : 0.25);
      const Canvas canvas = {place, width, height};
      const u32 seed = static_cast<u32>(i) + (side > 0.0f ? 10u : 3u);
      add_frame(pieces, canvas, 0.12f, kGold);
      if (kind == 0) paint_landscape(pieces, canvas, 0.37f + 0.61f * static_cast<float>(seed));
      if (kind == 1) paint_fields(pieces, canvas, seed);
      if (kind == 2) paint_circles(pieces, canvas, seed);
    }
  }
  const Canvas view = {Placement::at({-1.7f, 1.25f, -kEndZ}), 3.4f, 2.2f};
  add_frame(pieces, view, 0.18f, kGold);
  paint_landscape(pieces, view, 2.15f);
  const Canvas mirror = {Placement::at({1.2f, 1.05f, kEndZ}, 0.5), 2.4f, 2.9f};
  add_frame(pieces, mirror, 0.16f, kGold);
  mirror.rectangle(pieces, 0.0f, 0.0f, mirror.width, mirror.height, 0, kMirror);
}

}  // namespace raywalk::museum
