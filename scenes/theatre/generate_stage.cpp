// The stage: boards, the gilded proscenium, curtains and a grand piano.
#include "scenes/theatre/parts.h"

namespace raywalk::theatre {

Vec3 on_arch(float t, float wider) {
  const float half = kArchHalf + wider, crown = kArchCrown + wider;
  if (t < 0.25f) return {-half, kStage + 4.0f * t * (kArchSpring - kStage), kProscenium};
  if (t > 0.75f) return {half, kStage + 4.0f * (1.0f - t) * (kArchSpring - kStage), kProscenium};
  const double turns = 0.5 - (t - 0.25);
  return {half * static_cast<float>(cosine_turns(turns)),
          kArchSpring + (crown - kArchSpring) * static_cast<float>(sine_turns(turns)), kProscenium};
}

namespace {

/// Where the apron's front edge passes x.
float apron_z(float x) {
  const float part = x / 7.4f;
  return kProscenium + 0.15f + 1.25f * (1.0f - part * part);
}

void add_boards(Pieces& pieces) {
  constexpr int kPlanks = 28;
  const float width = 2.0f * kHalfWidth / kPlanks;
  for (int i = 0; i < kPlanks; ++i) {
    const float x0 = -kHalfWidth + width * static_cast<float>(i);
    const auto plank = [=](float u, float v) {
      const float x = x0 + u * (width - 0.006f);
      const float front = larger(apron_z(x), kProscenium);
      return Vec3{x, kStage, front + v * (-kHalfLength - front)};
    };
    add_sheet(pieces, plank, {1, 1}, kBoards);
  }
  const float reach = 7.4f;
  const auto front = [=](float u, float v) {
    const float x = reach * (2.0f * u - 1.0f);
    return Vec3{x, v * kStage, apron_z(x) - 0.05f};
  };
  add_sheet(pieces, front, {16, 1}, kWood);
  const auto lip = [=](float u, float v) {
    const float x = reach * (1.0f - 2.0f * v);
    const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
    return Vec3{x, kStage - 0.05f + 0.06f * c, apron_z(x) + 0.06f * s - 0.02f};
  };
  add_sheet(pieces, lip, {6, 20}, kGold);
  add_plate(pieces, {-kHalfWidth, 0.0f, kProscenium}, {2.0f * kHalfWidth, 0.0f, 0.0f}, {0.0f, kStage, 0.0f}, kWood);
}

/// Wall from the arch's rim to walls and ceiling, the depth of the opening, and gilded mouldings.
void add_proscenium(Pieces& pieces) {
  const auto outer = [](float t) {
    if (t < 0.25f) return Vec3{-kHalfWidth, 4.0f * t * kArchSpring, kProscenium};
    if (t > 0.75f) return Vec3{kHalfWidth, 4.0f * (1.0f - t) * kArchSpring, kProscenium};
    // The corners of the ceiling fall on whole cells.
    const float around = (t - 0.25f) * 2.0f, corner = 0.25f;
    if (around < corner) {
      return Vec3{-kHalfWidth, kArchSpring + around / corner * (kHeight - kArchSpring), kProscenium};
    }
    if (around > 1.0f - corner) {
      return Vec3{kHalfWidth, kArchSpring + (1.0f - around) / corner * (kHeight - kArchSpring), kProscenium};
    }
    const float across = (around - corner) / (1.0f - 2.0f * corner);
    return Vec3{kHalfWidth * (2.0f * across - 1.0f), kHeight, kProscenium};
  };
  const auto wall = [=](float u, float v) {
    const Vec3 rim = on_arch(u);
    return rim + v * (outer(u) - rim);
  };
  add_sheet(
      pieces, [=](float u, float v) { return wall(1.0f - u, v); }, {32, 1}, kWall);
  const auto depth = [](float u, float v) { return on_arch(u) - Vec3{0.0f, 0.0f, 0.5f * v}; };
  add_sheet(
      pieces, [=](float u, float v) { return depth(1.0f - u, v); }, {32, 1}, kGold);
  const auto moulding = [&](float wider, float thick, u32 sides) {
    const auto bead = [=](float u, float v) {
      const Vec3 rim = on_arch(v, wider), more = on_arch(v, wider + 1.0f);
      const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
      return rim + thick * c * normalized(more - rim + Vec3{0.0f, 1e-3f, 0.0f}) + Vec3{0.0f, 0.0f, thick * s};
    };
    add_sheet(pieces, bead, {sides, 32}, kGold);
  };
  moulding(0.06f, 0.10f, 8);
  moulding(0.42f, 0.07f, 6);
  // The crest over the crown.
  const Placement crest = Placement::at({0.0f, kArchCrown + 0.35f, kProscenium});
  add_pad(pieces, crest, {0.0f, 0.35f, 0.08f}, {0.42f, 0.36f, 0.10f}, 0.09f, kGold, 2);
  for (const float side : {-1.0f, 1.0f}) {
    add_tube(pieces, crest,
             {{0.40f * side, 0.25f, 0.08f},
              {0.95f * side, 0.55f, 0.10f},
              {1.35f * side, 0.30f, 0.10f},
              {1.15f * side, 0.02f, 0.10f},
              {0.90f * side, 0.15f, 0.10f},
              {1.05f * side, 0.30f, 0.12f}},
             0.07f, {7, 12}, kGold);
  }
}

void add_curtains(Pieces& pieces) {
  for (const float side : {-1.0f, 1.0f}) {
    // Tied back at a third of its height.
    const auto drape = [=](float u, float v) {
      const float height = 1.0f - v, tie = 0.36f;
      const float away = height < tie ? (tie - height) / tie : (height - tie) / (1.0f - tie);
      const float inner = height < tie ? 5.15f - 0.45f * away : 5.15f - 2.35f * away * away;
      const float x = kArchHalf + 0.35f + u * (inner - kArchHalf - 0.35f);
      const float fold = static_cast<float>(sine_turns(9.0 * u + 0.12 * static_cast<double>(v)));
      return Vec3{side * x, kStage + 0.03f + 5.3f * height, kProscenium - 0.85f + (0.05f + 0.11f * away) * fold};
    };
    add_sheet(
        pieces, [=](float u, float v) { return drape(side < 0.0f ? u : 1.0f - u, 1.0f - v); }, {63, 8}, kVelvet);
    add_pad(pieces, Placement::at({side * 5.72f, kStage + 0.03f + 5.3f * 0.36f, kProscenium - 0.85f}), {},
            {0.62f, 0.07f, 0.11f}, 0.05f, kGold);
  }
  const auto valance = [](float u, float v) {
    const float x = kArchHalf * 1.05f * (2.0f * u - 1.0f);
    const float scallop = 0.5f - 0.5f * static_cast<float>(cosine_turns(7.0 * u));
    const float low = 5.45f - 0.45f * scallop;
    const float fold = static_cast<float>(sine_turns(28.0 * u));
    return Vec3{x, low + v * (6.7f - low), kProscenium - 0.6f + 0.06f * fold * (1.1f - v)};
  };
  add_sheet(pieces, valance, {112, 2}, kVelvet);
  const auto fringe = [=](float u, float v) { return valance(u, 0.0f) + Vec3{0.0f, 0.14f * (v - 0.8f), 0.012f}; };
  add_sheet(pieces, fringe, {112, 1}, kGold);
  // The backcloth hangs in soft folds on a curve.
  const auto backcloth = [](float u, float v) {
    const float x = 8.2f * (2.0f * u - 1.0f), part = x / 8.2f;
    const float fold = static_cast<float>(sine_turns(22.0 * u + 0.2 * static_cast<double>(v)));
    return Vec3{x, kStage + 6.6f * v, -11.1f + 2.4f * part * part + 0.09f * fold};
  };
  add_sheet(pieces, backcloth, {110, 3}, kBackdrop);
}

void add_piano(Pieces& pieces) {
  const Placement place = Placement::at({0.0f, kStage, -7.9f}, 0.02);
  // Keys to the left (the pianist looks to +x), the bent side away from the audience.
  const std::vector<Vec3> rim = {{-0.75f, 0.0f, 0.72f}, {0.1f, 0.0f, 0.73f},    {0.95f, 0.0f, 0.70f},
                                 {1.38f, 0.0f, 0.40f},  {1.30f, 0.0f, 0.02f},   {0.80f, 0.0f, -0.22f},
                                 {0.25f, 0.0f, -0.50f}, {-0.30f, 0.0f, -0.70f}, {-0.75f, 0.0f, -0.72f},
                                 {-0.76f, 0.0f, 0.0f},  {-0.75f, 0.0f, 0.72f}};
  const auto outline = [=](float t) { return curve_at(rim, t); };
  const Vec3 middle = {0.1f, 0.0f, 0.1f};
  add_slab(pieces, place, outline, middle, 0.64f, 0.96f, 40, kLacquer);
  // The lid stands open on a prop: the same rim turned up around the straight side at the back.
  const auto lid = [=](float u, float v) {
    const Vec3 p = middle + (0.02f + 0.98f * (1.0f - v)) * (outline(u) - middle);
    const float out = p.z + 0.72f;
    return place.point({p.x, 0.97f + 0.62f * out, -0.72f + 0.78f * out});
  };
  add_sheet(pieces, lid, {40, 2}, kLacquer);
  add_tube(pieces, place, {{0.75f, 0.95f, 0.55f}, {0.75f, 1.35f, 0.40f}, {0.75f, 1.72f, 0.25f}}, 0.012f, {6, 2},
           kBrass);
  add_block(pieces, place, {-1.02f, 0.64f, -0.66f}, {-0.74f, 0.72f, 0.66f}, kLacquer);
  add_block(pieces, place, {-0.98f, 0.72f, -0.58f}, {-0.80f, 0.745f, 0.58f}, kIvory);
  add_block(pieces, place, {-0.60f, 0.97f, -0.40f}, {-0.57f, 1.22f, 0.40f}, kLacquer);
  const std::vector<ProfilePoint> leg = {{0.05f, 0.0f}, {0.07f, 0.05f}, {0.05f, 0.10f}, {0.05f, 0.35f}, {0.09f, 0.64f}};
  for (const Vec3 foot : {Vec3{-0.65f, 0.0f, 0.55f}, Vec3{-0.65f, 0.0f, -0.55f}, Vec3{1.05f, 0.0f, 0.25f}}) {
    add_lathe(pieces, place.inner(foot), leg, 8, kLacquer);
  }
  const Placement bench = place.inner({-1.5f, 0.0f, 0.0f});
  add_pad(pieces, bench, {0.0f, 0.47f, 0.0f}, {0.19f, 0.05f, 0.40f}, 0.035f, kVelvet);
  for (const float x : {-0.14f, 0.14f}) {
    for (const float z : {-0.33f, 0.33f}) {
      add_block(pieces, bench, {x - 0.025f, 0.0f, z - 0.025f}, {x + 0.025f, 0.43f, z + 0.025f}, kLacquer);
    }
  }
}

}  // namespace

void add_stage(Pieces& pieces) {
  add_boards(pieces);
  add_proscenium(pieces);
  add_curtains(pieces);
  add_piano(pieces);
}

}  // namespace raywalk::theatre
