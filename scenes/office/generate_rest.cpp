// A plant, the wastebasket, the coat stand, a mirror, pictures and a clock.
#include "scenes/office/parts.h"

namespace raywalk::office {
namespace {

/// One arching leaf that starts in `root`.
void add_leaf(Pieces& pieces, Vec3 root, double turns, float reach, float rise) {
  const Placement place = Placement::at(root, turns);
  const auto leaf = [=](float u, float v) {
    const float side = 2.0f * u - 1.0f;
    const float half_width = 0.34f * reach * v * (1.0f - v) * (1.7f - 0.9f * v) + 0.003f;
    return place.point({reach * v * (0.3f + 0.7f * v), rise * v * (1.9f - 1.2f * v) + 0.3f * half_width * side * side,
                        -half_width * side});
  };
  add_sheet(pieces, leaf, {4, 8}, kLeaf);
}

void add_plant(Pieces& pieces, Vec3 at) {
  add_lathe(pieces, Placement::at(at),
            {{0.002f, 0.001f},
             {0.12f, 0.001f},
             {0.15f, 0.10f},
             {0.18f, 0.30f},
             {0.19f, 0.33f},
             {0.17f, 0.33f},
             {0.16f, 0.29f},
             {0.002f, 0.28f}},
            28, kPot);
  Random random(21);
  for (int i = 0; i < 38; ++i) {
    const float young = static_cast<float>(i) / 38.0f;
    const float reach = random.between(0.28f, 0.40f) * (1.0f - 0.5f * young);
    add_leaf(pieces, at + Vec3{0.0f, 0.28f, 0.0f}, 0.381966 * i + random.between(-0.03f, 0.03f), reach,
             0.25f + 0.8f * young + random.between(0.0f, 0.12f));
  }
}

/// A basket of wire with crumpled paper in it.
void add_wastebasket(Pieces& pieces, Vec3 at) {
  const Placement place = Placement::at(at);
  const auto ring = [&](float radius, float height, float thick) {
    add_lathe(pieces, place,
              {{radius, height - thick},
               {radius + thick, height},
               {radius, height + thick},
               {radius - thick, height},
               {radius, height - thick}},
              32, kSteel);
  };
  ring(0.155f, 0.30f, 0.007f);
  ring(0.135f, 0.16f, 0.004f);
  ring(0.115f, 0.02f, 0.006f);
  add_slab(
      pieces, place, [](float t) { return 0.112f * on_circle(t); }, {}, 0.008f, 0.014f, 24, kSteel);
  for (int i = 0; i < 32; ++i) {
    const Vec3 d = on_circle(i / 32.0);
    add_tube(pieces, place,
             {0.115f * d + Vec3{0, 0.02f, 0}, 0.135f * d + Vec3{0, 0.16f, 0}, 0.155f * d + Vec3{0, 0.30f, 0}}, 0.0028f,
             {4, 2}, kSteel);
  }
  const Vec3 balls[] = {{0.03f, 0.065f, 0.02f}, {-0.05f, 0.07f, -0.03f}, {0.01f, 0.13f, -0.02f}};
  for (u32 k = 0; k < 3; ++k) {
    const Vec3 centre = place.point(balls[k]);
    const auto crumpled = [=](Vec3 d, float) {
      const float bump =
          static_cast<float>(sine_turns(1.3 * d.x + 0.9 * d.y + k) * cosine_turns(1.1 * d.z - 1.4 * d.y));
      return SurfacePoint{centre + (0.045f + 0.008f * bump) * d, d};
    };
    pieces.ball(crumpled, kPaper, 100.0);
  }
}

void add_coat_stand(Pieces& pieces, Vec3 at) {
  const Placement place = Placement::at(at);
  add_lathe(pieces, place,
            {{0.19f, 0.0f},
             {0.19f, 0.015f},
             {0.05f, 0.04f},
             {0.024f, 0.08f},
             {0.020f, 0.9f},
             {0.018f, 1.66f},
             {0.035f, 1.69f},
             {0.02f, 1.75f},
             {0.002f, 1.765f}},
            18, kWood);
  for (int i = 0; i < 6; ++i) {
    const Vec3 d = on_circle(i / 6.0 + 0.03);
    const float low = i % 2 ? 1.45f : 1.58f;
    const auto p = [&](float out, float y) { return out * d + Vec3{0.0f, y, 0.0f}; };
    add_tube(pieces, place, {p(0.0f, low), p(0.10f, low + 0.01f), p(0.15f, low + 0.09f)}, 0.010f, {8, 8}, kWood);
    add_sphere(pieces, place.point(p(0.15f, low + 0.095f)), 0.016f, kBrass, 0.0);
  }
}

/// A framed rectangle, its lower middle at the place, looking along local +z.
void add_framed(Pieces& pieces, const Placement& place, float width, float height, u32 frame, u32 inside) {
  const float f = 0.03f, x = 0.5f * width;
  add_block(pieces, place, {-x - f, -f, 0.0f}, {-x, height + f, 0.03f}, frame);
  add_block(pieces, place, {x, -f, 0.0f}, {x + f, height + f, 0.03f}, frame);
  add_block(pieces, place, {-x, -f, 0.0f}, {x, 0.0f, 0.03f}, frame);
  add_block(pieces, place, {-x, height, 0.0f}, {x, height + f, 0.03f}, frame);
  add_plate(pieces, place.point({-x, 0.0f, 0.015f}), place.direction({width, 0.0f, 0.0f}), {0.0f, height, 0.0f},
            inside);
}

void add_wall_things(Pieces& pieces) {
  // A landscape of three bands over the desk, two small prints beside it, a mirror by the door.
  const Placement picture = Placement::at({-kHalf, 1.42f, -0.45f}, 0.25);
  add_framed(pieces, picture, 1.05f, 0.62f, kWood, kScreenBlue);
  const auto hills = [&](float base, float swing, double phase, float off, u32 material) {
    const auto shape = [=](float u, float v) {
      const float crest = base + swing * static_cast<float>(sine_turns(1.3 * u + phase));
      return picture.point({-0.525f + 1.05f * u, v * crest, 0.016f + off});
    };
    add_sheet(pieces, shape, {24, 1}, material);
  };
  hills(0.33f, 0.07f, 0.1, 0.0f, kSea);
  hills(0.22f, 0.05f, 0.55, 0.001f, kBookGreen);
  hills(0.10f, 0.04f, 0.3, 0.002f, kBookCream);
  const u32 prints[] = {kBookRed, kBookBlue};
  for (int i = 0; i < 2; ++i) {
    const Placement place = Placement::at({-kHalf, 1.5f, 0.62f + 0.5f * static_cast<float>(i)}, 0.25);
    add_framed(pieces, place, 0.30f, 0.40f, kPlastic, kPaper);
    add_slab(
        pieces, Placement::at(place.point({0.0f, 0.2f, 0.0f}), 0.25),
        [](float t) {
          const Vec3 d = on_circle(t);
          return Vec3{0.09f * d.x, -0.09f * d.z, 0.017f};
        },
        {0.0f, 0.0f, 0.017f}, 0.0f, 0.0f, 20, prints[i]);
  }
  add_framed(pieces, Placement::at({0.35f, 0.75f, kHalf}, 0.5), 0.55f, 1.25f, kBrass, kMirror);

  const Placement clock = Placement::at({-0.65f, 1.95f, kHalf}, 0.5);
  const auto disc = [&](float radius, float off, u32 material) {
    const auto shape = [=](float u, float v) {
      return clock.point(
          {v * radius * static_cast<float>(sine_turns(u)), v * radius * static_cast<float>(cosine_turns(u)), off});
    };
    add_sheet(
        pieces, [=](float u, float v) { return shape(u, 0.01f + 0.99f * v); }, {32, 1}, material);
  };
  disc(0.15f, 0.012f, kPaper);
  const auto rim = [=](float u, float v) {
    const float radius = 0.155f + 0.016f * static_cast<float>(cosine_turns(u));
    return clock.point({radius * static_cast<float>(sine_turns(v)), radius * static_cast<float>(cosine_turns(v)),
                        0.016f + 0.016f * static_cast<float>(sine_turns(u))});
  };
  add_sheet(pieces, rim, {8, 32}, kChrome);
  const auto hand = [&](double turns, float from, float to, float half) {
    const float s = static_cast<float>(sine_turns(turns)), c = static_cast<float>(cosine_turns(turns));
    const Vec3 along = clock.direction({s, c, 0.0f}), across = clock.direction({c, -s, 0.0f});
    add_plate(pieces, clock.point({0.0f, 0.0f, 0.015f}) + from * along - half * across, 2.0f * half * across,
              (to - from) * along, kPlastic);
  };
  hand(0.84, -0.02f, 0.08f, 0.006f);
  hand(0.14, -0.02f, 0.12f, 0.004f);
  for (int i = 0; i < 12; ++i) hand(i / 12.0, 0.115f, 0.135f, 0.003f);
}

}  // namespace

void add_rest(Pieces& pieces) {
  add_plant(pieces, {1.83f, 0.0f, -1.86f});
  add_wastebasket(pieces, {-1.15f, 0.0f, 0.88f});
  add_coat_stand(pieces, {1.95f, 0.0f, 1.62f});
  add_wall_things(pieces);
}

}  // namespace raywalk::office
