// Verdicts ray by ray, shared out over the processors.
#include "server/accuracy/sweep/errors.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace raywalk::accuracy {
namespace {

constexpr u64 kAtOnce = 16'384;  // places between two reports

/// t moved by `ulps` floats towards infinity; t is not negative.
float moved(float t, u32 ulps) {
  return t >= kMaxFloat ? t : float_of(bits_of(larger(t, 0.0f)) + ulps);
}

bool same(const Hit& a, const Hit& b) {
  return bits_of(a.t) == bits_of(b.t) && a.id == b.id;
}

/// Within a few near radii.
bool passes_by(const Ray& ray, Vec3 p) {
  const Vec3 to = p - ray.o;
  const float distance = length(cross(to, normalized(ray.d)));
  return distance <= 8.0f * static_cast<float>(oracle::kNear) * largest(magnitude(to));
}

/// Sums of two parts.
void add_to(SweepErrors& sum, const SweepErrors& part) {
  sum.figures.add(part.figures);
  sum.wrong += part.wrong;
  if (sum.self_hits) *sum.self_hits += part.self_hits.value_or(0);
  if (sum.double_hits) *sum.double_hits += part.double_hits.value_or(0);
  sum.nan_outputs += part.nan_outputs;
}

}  // namespace

std::vector<Ray> continued_rays(const std::vector<Ray>& rays, const std::vector<Hit>& hits) {
  std::vector<Ray> out = rays;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (hits[i].id == kMiss) {
      out[i].d = {0, 0, 0};  // an invalid ray misses
      continue;
    }
    out[i].tmin = moved(hits[i].t, 1);
    out[i].tmax = smaller(moved(hits[i].t, 1 + kDoubleHitUlps), rays[i].tmax);
  }
  return out;
}

bool is_double_hit(const Ray& ray, SceneView scene, u32 first, u32 second, const VertexFans& fans) {
  const Corners &s = scene.corners()[first], &t = scene.corners()[second];
  const Vec3 a[3] = {s.a, s.b, s.c}, b[3] = {t.a, t.b, t.c};
  Vec3 shared[3];
  u32 count = 0;
  Vec3 apex_a = a[0], apex_b = b[0];
  for (const Vec3& p : a) {
    const bool both = p == b[0] || p == b[1] || p == b[2];
    if (both) shared[count++] = p;
    if (!both) apex_a = p;
  }
  for (const Vec3& p : b) {
    if (p != a[0] && p != a[1] && p != a[2]) apex_b = p;
  }
  if (count == 0 || count == 3) return false;
  const auto is_inside = [&](const Corners& of) {
    return oracle::classify(ray, of).position == oracle::Position::inside;
  };
  if (is_inside(s) && is_inside(t)) return false;
  for (u32 i = 0; i < count; ++i) {
    if (passes_by(ray, shared[i])) return fans.are_one_surface(shared[i], ray.d, first, second);
  }
  if (count == 1) return false;
  // The neighbours lie on different sides of the plane through the ray's origin and their edge.
  const Vec3 plane = cross(shared[0] - ray.o, shared[1] - ray.o);
  return dot(plane, apex_a - shared[0]) * dot(plane, apex_b - shared[0]) < 0.0f;
}

Judge::Judge(const oracle::SceneOracle& oracle, SceneView scene, const VertexFans& fans, const RayList& list)
    : oracle_(oracle),
      scene_(scene),
      fans_(fans),
      list_(list),
      stride_((list.rays.size() + kMostJudged - 1) / kMostJudged),
      known_(list.rays.empty() ? 0 : (list.rays.size() + stride_ - 1) / stride_) {}

u64 Judge::judged() const {
  return known_.size();
}

const oracle::Judgement& Judge::judgement_of(u64 place, const Answers& answers) {
  const u64 i = ray_of(place);
  const bool any = list_.query() == RayQuery::any;
  const Hit hit = any ? Hit{} : answers.hits[i];
  const u8 occluded = any ? answers.occluded[i] : u8{0};
  for (const Known& known : known_[place]) {
    if (same(known.hit, hit) && known.occluded == occluded) return known.judgement;
  }
  const Ray& ray = list_.rays[i];
  known_[place].push_back({hit, occluded, any ? oracle_.judge_occluded(ray, occluded != 0) : oracle_.judge(ray, hit)});
  return known_[place].back().judgement;
}

void Judge::add(u64 place, const Answers& answers, SweepErrors& errors) {
  const u64 i = ray_of(place);
  const Hit& hit = answers.hits[i];
  const oracle::Judgement& judgement = judgement_of(place, answers);
  errors.figures.add(judgement);
  const bool nan = std::isnan(hit.t) || std::isnan(hit.u) || std::isnan(hit.v);
  const bool self = errors.self_hits && hit.id == list_.own[i];
  const bool twice = errors.double_hits && hit.id != kMiss && answers.beyond[i].id != kMiss &&
                     is_double_hit(list_.rays[i], scene_, hit.id, answers.beyond[i].id, fans_);
  errors.nan_outputs += nan;
  if (self) ++*errors.self_hits;
  if (twice) ++*errors.double_hits;
  errors.wrong += nan || self || twice || !is_acceptable(judgement.verdict);
}

SweepErrors Judge::errors_of(const Answers& answers, const std::function<void(double fraction)>& report) {
  SweepErrors none;
  if (is_spawned(list_.kind)) none.self_hits = 0;
  if (!answers.beyond.empty()) none.double_hits = 0;
  SweepErrors sum = none;
  for (u64 first = 0; first < judged(); first += kAtOnce) {
    report(static_cast<double>(first) / static_cast<double>(judged()));
    const u64 last = std::min(first + kAtOnce, judged());
    tbb::combinable<SweepErrors> parts([&] { return none; });
    tbb::parallel_for(tbb::blocked_range<u64>(first, last, 256), [&](const tbb::blocked_range<u64>& range) {
      SweepErrors& part = parts.local();
      for (u64 place = range.begin(); place != range.end(); ++place) add(place, answers, part);
    });
    parts.combine_each([&](const SweepErrors& part) { add_to(sum, part); });
  }
  return sum;
}

}  // namespace raywalk::accuracy
