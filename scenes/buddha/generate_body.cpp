// Crossed legs, a torso in a robe that leaves the right shoulder bare, arms, and hands that rest in the lap.
#include "scenes/buddha/parts.h"
#include "scenes/common/noise.h"

namespace raywalk::buddha {
namespace {

/// Folds of cloth across the lines s = constant: narrow valleys between round ridges.
float folds(float s, float pitch, Vec3 p) {
  const float wave = static_cast<float>(cosine_turns(s / pitch + 0.35f * noise(9.0f * p)));
  return wave * (1.0f - 0.25f * wave);
}

float grain(Vec3 p) {
  return 0.0006f * fractal_noise(60.0f * p, 2);
}

float legs(Vec3 p) {
  const Vec3 q = {magnitude(p.x), p.y, p.z};
  float d = to_rod(q, {0.09f, 1.055f, 0.00f}, {0.285f, 1.035f, 0.120f}, 0.092f, 0.082f);
  d = merged(d, to_rod(q, {0.290f, 1.028f, 0.130f}, {0.02f, 1.035f, 0.235f}, 0.070f, 0.062f), 0.05f);
  d = merged(d, to_ellipsoid(p, {0.0f, 1.03f, 0.02f}, {0.22f, 0.085f, 0.20f}), 0.05f);
  // The right foot lies on the left thigh, sole up.
  d = merged(d, to_rod(p, {0.055f, 1.095f, 0.235f}, {0.155f, 1.118f, 0.175f}, 0.030f, 0.036f), 0.025f);
  const float around = length({q.x - 0.02f, 0.0f, 1.5f * (p.z + 0.02f)});
  const float cloth = ramp(0.10f, 0.2f, around) * ramp(1.115f, 1.09f, p.y);
  return d - 0.0030f * cloth * folds(around - 0.9f * (p.y - 1.0f), 0.036f, p) - grain(p);
}

/// How far a point lies under the robe: its hem runs from the left shoulder's neck down to the right hip.
float under_robe(Vec3 p) {
  return 0.72f * (p.x - 0.055f) - 0.69f * (p.y - 1.43f) + 0.03f * noise({6.0f * p.x, 6.0f * p.y, 3.0f});
}

float torso(Vec3 p) {
  float d = to_rod(p, {0.0f, 1.06f, 0.005f}, {0.0f, 1.18f, 0.018f}, 0.155f, 0.135f);
  d = merged(d, to_rod(p, {-0.085f, 1.375f, 0.002f}, {0.085f, 1.375f, 0.002f}, 0.118f, 0.118f), 0.10f);
  return merged(d, to_rod(p, {-0.165f, 1.462f, -0.012f}, {0.165f, 1.462f, -0.012f}, 0.066f, 0.066f), 0.07f);
}

float bare_torso(Vec3 p) {
  const Vec3 q = {magnitude(p.x), p.y, p.z};
  const float d = merged(torso(p), to_rod(p, {0.0f, 1.46f, -0.005f}, {0.0f, 1.54f, 0.0f}, 0.072f, 0.060f), 0.05f);
  return merged(d, to_rod(q, {0.06f, 1.385f, 0.10f}, {0.075f, 1.39f, 0.10f}, 0.030f, 0.030f), 0.05f) - grain(p);
}

/// Lies on the torso below its hem and under the skin elsewhere.
float robe(Vec3 p) {
  const float under = under_robe(p), cloth = ramp(-0.004f, 0.004f, under);
  const float border = ramp(0.030f, 0.020f, under);
  const float fold = 0.0036f * (1.0f - border) * folds(under + 0.22f * p.z * p.z, 0.040f, p);
  return bare_torso(p) + 0.010f - cloth * (0.020f + 0.004f * border + fold);
}

/// A cylinder with three lines around it.
float neck(Vec3 p) {
  float d = to_rod(p, {0.0f, 1.48f, -0.005f}, {0.0f, 1.64f, 0.004f}, 0.066f, 0.055f);
  for (const float y : {1.545f, 1.566f, 1.587f}) {
    const float gap = (p.y - y) * 260.0f;
    d += 0.0022f / (1.0f + gap * gap);
  }
  return d - grain(p);
}

void add_arm(Pieces& pieces, float side) {
  const Vec3 shoulder = {0.200f * side, 1.455f, -0.012f}, elbow = {0.268f * side, 1.215f, 0.010f},
             wrist = {0.085f * side, 1.158f, 0.215f};
  const bool sleeve = side > 0.0f;
  const float thick = sleeve ? 0.012f : 0.0f;
  const auto upper = [=](Vec3 p) {
    float d = to_rod(p, shoulder, elbow, 0.066f + thick, 0.050f + thick);
    if (sleeve) d -= 0.0019f * folds(0.9f * p.y + 0.35f * p.z, 0.036f, p);
    return d - grain(p);
  };
  const auto lower = [=](Vec3 p) {
    float d = to_rod(p, elbow, wrist, 0.050f + thick, sleeve ? 0.046f : 0.031f);
    // The sleeve hangs from the forearm down to the thigh.
    if (sleeve) {
      d = merged(d, to_rod(p, {0.25f, 1.15f, 0.03f}, {0.15f, 1.125f, 0.15f}, 0.050f, 0.038f), 0.05f);
      d -= 0.0019f * folds(0.8f * p.x - 0.6f * p.z + 0.5f * p.y, 0.034f, p);
    }
    return d - grain(p);
  };
  add_carved(pieces, 0.5f * (shoulder + elbow), {0.085f, 0.19f, 0.075f}, upper, sleeve ? kRobe : kSkin, kEven);
  add_carved(pieces, 0.5f * (elbow + wrist) - Vec3{0.0f, sleeve ? 0.018f : 0.0f, 0.0f}, {0.15f, 0.085f, 0.16f}, lower,
             sleeve ? kRobe : kSkin, kEven);
}

/// A finger of three joints that lies from `root` towards `tip`, arched upwards.
void add_finger(Pieces& pieces, Vec3 root, Vec3 tip, float radius, float arch) {
  const Vec3 up = {0.0f, arch, 0.0f};
  std::vector<TubePoint> points = {{root, radius}};
  for (int i = 1; i < 5; ++i) {
    const float t = static_cast<float>(i) / 5.0f;
    const float knuckle = i % 2 ? 1.04f : 0.94f;
    points.push_back({root + t * (tip - root) + 4.0f * t * (1.0f - t) * up, radius * knuckle * (1.0f - 0.16f * t)});
  }
  points.push_back({tip, 0.62f * radius});
  points.push_back({tip + 0.5f * radius * normalized(tip - root), 0.05f * radius});
  add_tube(pieces, points, kSkin, 2.0 * kEven);
}

/// The right hand in the left, palms up, the thumbs' tips touching.
void add_hands(Pieces& pieces) {
  for (const float side : {1.0f, -1.0f}) {
    const float y = side > 0.0f ? 1.128f : 1.156f;
    const auto palm = [=](Vec3 p) {
      float d = to_rod(p, {0.088f * side, y + 0.012f, 0.215f}, {0.040f * side, y, 0.238f}, 0.030f, 0.024f);
      d = merged(d, to_ellipsoid(p, {0.030f * side, y, 0.240f}, {0.048f, 0.019f, 0.044f}), 0.02f);
      return d - grain(p);
    };
    add_carved(pieces, {0.045f * side, y, 0.235f}, {0.075f, 0.03f, 0.05f}, palm, kSkin, 2.0 * kEven);
    for (int i = 0; i < 4; ++i) {
      const float z = 0.212f + 0.0185f * static_cast<float>(i), reach = i == 0 || i == 3 ? 0.072f : 0.082f;
      add_finger(pieces, {0.012f * side, y, z}, {-reach * side, y + 0.004f, z + 0.004f}, 0.0105f, -0.004f);
    }
    add_finger(pieces, {0.055f * side, y + 0.010f, 0.268f}, {0.006f * side, 1.192f, 0.262f}, 0.0115f, 0.006f);
  }
}

}  // namespace

void add_body(Pieces& pieces) {
  add_carved(pieces, {0.0f, 1.035f, 0.075f}, {0.37f, 0.10f, 0.24f}, legs, kRobe, kEven);
  add_carved(pieces, {0.0f, 1.28f, 0.0f}, {0.21f, 0.31f, 0.16f}, bare_torso, kSkin, kEven);
  add_carved(pieces, {0.0f, 1.28f, 0.0f}, {0.21f, 0.31f, 0.16f}, robe, kRobe, kRelief);
  add_carved(pieces, {0.0f, 1.56f, 0.0f}, {0.065f, 0.10f, 0.065f}, neck, kSkin, kEven);
  add_arm(pieces, 1.0f);
  add_arm(pieces, -1.0f);
  add_hands(pieces);
}

}  // namespace raywalk::buddha
