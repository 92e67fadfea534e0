// Each ray follows from the seed and its own number alone.
#include "server/accuracy/sweep/ray_lists.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "server/device/outputs.h"

namespace raywalk::accuracy {
namespace {

constexpr u64 kMostPixels = 16;  // for each origin of spawned rays

/// Numbers of one ray (SplitMix64).
class Random {
 public:
  Random(u64 seed, RayKind kind, u64 ray) : state_(seed * 0x9e3779b97f4a7c15u + static_cast<u64>(kind)) {
    state_ = next() + ray;
  }
  u64 next() {
    u64 z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double real() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  u64 below(u64 end) { return next() % end; }
  Vec3 direction() {
    const double z = 2.0 * real() - 1.0, angle = 2.0 * std::numbers::pi * real();
    const double r = std::sqrt(1.0 - z * z);
    return {static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)), static_cast<float>(z)};
  }

 private:
  u64 state_;
};

Vec3 point_in(const Box& box, Random& random) {
  const Vec3 e = box.extent();
  const auto at = [&](float lo, float extent) { return lo + static_cast<float>(random.real()) * extent; };
  return {at(box.lo.x, e.x), at(box.lo.y, e.y), at(box.lo.z, e.z)};
}

float longest_edge(const Corners& t) {
  return larger(length(t.b - t.a), larger(length(t.c - t.b), length(t.a - t.c)));
}

Vec3 vertex_of(const Corners& t, u64 i) {
  return i % 3 == 0 ? t.a : i % 3 == 1 ? t.b : t.c;
}

/// Cosine density around the unit normal n: n plus a point of the unit sphere.
Vec3 bounced(Vec3 n, Random& random) {
  const Vec3 d = n + random.direction();
  return largest(magnitude(d)) > 1e-4f ? normalized(d) : n;
}

}  // namespace

u32 primary_side(u64 rays) {
  const double side = std::sqrt(static_cast<double>(rays) / kPrimaryFrames);
  return kBlockSide * std::max(1u, static_cast<u32>(std::lround(side / kBlockSide)));
}

RayMaker::RayMaker(const LoadedScene& scene, u64 rays, u64 seed, Closest closest)
    : scene_(scene), view_{scene.blob->data()}, rays_(rays), seed_(seed), closest_(std::move(closest)) {}

RayList RayMaker::make(RayKind kind, const std::string& spawn) {
  switch (kind) {
    case RayKind::primary:
      return {kind, primary(rays_), {}};
    case RayKind::random:
      return {kind, random(), {}};
    case RayKind::edge:
    case RayKind::vertex:
      return aimed(kind);
    case RayKind::shadow:
    case RayKind::diffuse:
      break;
  }
  const std::vector<KnobRow>& rows = spawn_rows();
  const auto row = std::ranges::find(rows, spawn, &KnobRow::name);
  if (row != rows.end()) return spawned(kind, spawn_origin_of(static_cast<u32>(row - rows.begin())));
  throw std::invalid_argument("there is no spawn offset '" + spawn + "'");
}

std::vector<Ray> RayMaker::primary(u64 wanted) const {
  const u32 side = primary_side(wanted);
  std::vector<Ray> rays;
  rays.reserve(u64{kPrimaryFrames} * side * side);
  for (u32 frame = 0; frame < kPrimaryFrames; ++frame) {
    FrameJob job;
    job.camera = pose_at(scene_.camera_path, frame, kPrimaryFrames);
    job.width = job.height = side;
    const Camera camera = frame_args(job).camera;
    in_block_order(side, side, [&](u32 x, u32 y, u64) { rays.push_back(primary_ray(camera, x, y)); });
  }
  return rays;
}

std::vector<RayMaker::Origin> RayMaker::hits_of(const std::vector<Ray>& rays) const {
  const std::vector<Hit> hits = closest_(rays);
  std::vector<Origin> found;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].id != kMiss) found.push_back({hits[i], rays[i].d});
  }
  return found;
}

/// Of more pixels where the scene does not fill the frames; of these as many as are wanted, evenly spaced.
const std::vector<RayMaker::Origin>& RayMaker::origins() {
  if (!origins_.empty()) return origins_;
  std::vector<Origin> found = hits_of(primary(rays_));
  if (found.empty()) return origins_;
  if (found.size() < rays_) found = hits_of(primary(std::min(rays_ * rays_ / found.size(), kMostPixels * rays_)));
  const u64 count = std::min<u64>(rays_, found.size());
  for (u64 i = 0; i < count; ++i) origins_.push_back(found[i * found.size() / count]);
  return origins_;
}

RayList RayMaker::spawned(RayKind kind, SpawnOrigin origin_at) {
  RayList list{kind, {}, {}};
  if (kind == RayKind::shadow && view_.light_count() == 0) return list;
  for (const Origin& origin : origins()) {
    const u64 number = list.rays.size();
    const Surface s = surface_at<0>(view_, origin.hit, origin.d, 0.0f);
    if (kind == RayKind::shadow) {
      const Vec3 lamp = view_.lights()[number / kBlockRays % view_.light_count()].position;
      const Vec3 o = origin_at(s, lamp - s.position);
      list.rays.push_back({o, 0.0f, lamp - o, 1.0f});
    } else {
      Random random(seed_, kind, number);
      const Vec3 d = bounced(s.front ? s.geometric_normal : -s.geometric_normal, random);
      list.rays.push_back({origin_at(s, d), 0.0f, d, kMaxFloat});
    }
    list.own.push_back(origin.hit.id);
  }
  return list;
}

std::vector<Ray> RayMaker::random() const {
  std::vector<Ray> rays;
  if (scene_.bounds.empty()) return rays;
  rays.reserve(rays_);
  for (u64 i = 0; i < rays_; ++i) {
    Random random(seed_, RayKind::random, i);
    const Vec3 o = point_in(scene_.bounds, random);
    rays.push_back({o, 0.0f, random.direction(), kMaxFloat});
  }
  return rays;
}

/// From a place near the target, so that little stands between; in a dense mesh some other triangle may, which is as
/// good.
RayList RayMaker::aimed(RayKind kind) const {
  RayList list{kind, {}, {}};
  std::vector<u32> targets;
  for (u32 id = 0; id < view_.triangle_count(); ++id) {
    const Corners& t = view_.corners()[id];
    if (is_finite(t) && longest_edge(t) > 0.0f) targets.push_back(id);
  }
  if (targets.empty()) return list;
  for (u64 i = 0; i < rays_; ++i) {
    Random random(seed_, kind, i);
    const u32 id = targets[random.below(targets.size())];
    const Corners& t = view_.corners()[id];
    const u64 corner = random.below(3);
    const Vec3 from = vertex_of(t, corner), to = vertex_of(t, corner + 1);
    const float along = kind == RayKind::edge ? static_cast<float>(random.real()) : 0.0f;
    const Vec3 target = fma(along, to - from, from);
    const float distance = longest_edge(t) * static_cast<float>(std::pow(10.0, 1.5 * random.real()));
    const Vec3 o = fma(distance, random.direction(), target);
    list.rays.push_back({o, 0.0f, target - o, kMaxFloat});
    list.own.push_back(id);
  }
  return list;
}

std::vector<Ray> RayMaker::misses() const {
  std::vector<Ray> rays;
  if (scene_.bounds.empty()) return rays;
  const Vec3 size = scene_.bounds.extent();
  const float step = larger(largest(size), 1e-6f);
  rays.reserve(rays_);
  for (u64 i = 0; i < rays_; ++i) {
    Random random(seed_, RayKind::random, i);
    const Vec3 o = scene_.bounds.hi + Vec3{step, step, step};
    rays.push_back({o, 0.0f, magnitude(random.direction()), kMaxFloat});
  }
  return rays;
}

std::vector<Ray> made_invalid(std::vector<Ray> rays) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  for (u64 i = 0; i < rays.size(); ++i) {
    Ray& ray = rays[i];
    const float bad = i / 5 % 2 == 0 ? kNaN : kInfinity;
    switch (i % 5) {
      case 0:
        ray.d = {0, 0, 0};
        break;
      case 1:
        ray.o.x = bad;
        break;
      case 2:
        ray.d.y = bad;
        break;
      case 3:
        ray.tmin = bad;
        break;
      default:
        ray.tmax = bad;
    }
  }
  return rays;
}

}  // namespace raywalk::accuracy
