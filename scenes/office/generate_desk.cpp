// The desk: two tops at a right angle, a chest of drawers, legs.
#include "scenes/office/parts.h"

namespace raywalk::office {
namespace {

/// A bow-shaped handle along local x that stands off by `out`.
void add_handle(Pieces& pieces, const Placement& place, Vec3 at, float half, float out) {
  const auto p = [&](float x, float z) { return at + Vec3{x, 0.0f, z}; };
  add_tube(pieces, place, {p(-half, 0.0f), p(-half, out), p(half, out), p(half, 0.0f)}, 0.006f, {6, 9}, kChrome);
}

void add_drawers(Pieces& pieces, const Placement& place) {
  add_block(pieces, place, {-0.21f, 0.05f, -0.60f}, {0.21f, kDeskTop - 0.05f, -0.01f}, kDesk);
  const float tops[] = {0.05f, 0.36f, 0.53f, kDeskTop - 0.05f};
  for (int i = 0; i < 3; ++i) {
    const float middle = 0.5f * (tops[i] + tops[i + 1]), half = 0.5f * (tops[i + 1] - tops[i]) - 0.006f;
    add_pad(pieces, place, {0.0f, middle, 0.0f}, {0.204f, half, 0.012f}, 0.008f, kDesk);
    add_handle(pieces, place, {0.0f, middle, 0.01f}, 0.07f, 0.03f);
  }
  add_block(pieces, place, {-0.20f, 0.0f, -0.58f}, {0.20f, 0.05f, -0.03f}, kPlastic);
}

}  // namespace

void add_desk(Pieces& pieces) {
  // The long part stands along the left wall, the short one under the window.
  const Placement here;
  const float y = kDeskTop - 0.02f;
  add_pad(pieces, here, {-1.77f, y, -0.30f}, {0.40f, 0.02f, 1.15f}, 0.014f, kDesk, 2);
  add_pad(pieces, here, {-1.27f, y, -1.80f}, {0.90f, 0.02f, 0.36f}, 0.014f, kDesk, 2);
  add_block(pieces, here, {-2.15f, 0.35f, -1.4f}, {-2.12f, y - 0.02f, 0.8f}, kDesk);
  add_drawers(pieces, Placement::at({-1.40f, 0.0f, 0.60f}, 0.25));
  for (const Vec3 foot : {Vec3{-1.44f, 0.0f, -1.30f}, Vec3{-0.44f, 0.0f, -1.52f}, Vec3{-0.44f, 0.0f, -2.06f}}) {
    add_lathe(pieces, Placement::at(foot),
              {{0.04f, 0.0f}, {0.04f, 0.02f}, {0.025f, 0.03f}, {0.025f, y - 0.05f}, {0.05f, y - 0.02f}}, 14, kChrome);
  }
}

}  // namespace raywalk::office
