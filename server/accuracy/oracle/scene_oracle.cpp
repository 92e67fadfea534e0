// Candidates come from the beam tree; exact distances order them.
#include "server/accuracy/oracle/scene_oracle.h"

#include <limits>

#include "server/accuracy/oracle/sealed.h"

namespace raywalk::oracle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The rounded distance decides unless it is at an end itself.
bool is_in_interval(const Ray& ray, const Corners& triangle, const Crossing& crossing) {
  const float t = crossing.t;
  if (t < ray.tmin || t > ray.tmax) return false;
  return (t > ray.tmin || compare_distance(ray, triangle, ray.tmin) >= 0) &&
         (t < ray.tmax || compare_distance(ray, triangle, ray.tmax) <= 0);
}

bool is_tie(const Crossing& first, const Crossing& other) {
  return std::abs(other.precise_t - first.precise_t) <= kTieUlps * ulp_at(first.precise_t);
}

}  // namespace

SceneOracle::SceneOracle(SceneView scene) : scene_(scene), tree_(scene) {}

bool SceneOracle::consider(const Ray& ray, u32 id, std::vector<Candidate>& candidates) const {
  const Crossing crossing = classify(ray, triangle(id));
  if (!crossing.touched() || crossing.high < ray.tmin || crossing.low > ray.tmax) return false;
  const bool counts = crossing.met() && is_in_interval(ray, triangle(id), crossing);
  candidates.push_back({id, crossing, counts, counts && crossing.low >= ray.tmin && crossing.high <= ray.tmax});
  return true;
}

SceneOracle::Survey SceneOracle::survey_front(const Ray& ray) const {
  Survey survey;
  if (!is_valid(ray)) return survey;
  std::vector<Candidate>& found = survey.candidates;
  double end = ray.tmax, least_end = end;
  const auto add = [&](u32 id) {
    if (!consider(ray, id, found) || !found.back().counts) return;
    const Candidate& candidate = found.back();
    if (survey.closest == kMiss || candidate.crossing.t < found[survey.closest].crossing.t ||
        (candidate.crossing.t == found[survey.closest].crossing.t && id < found[survey.closest].id)) {
      survey.closest = static_cast<u32>(found.size() - 1);
      end = candidate.crossing.high;
      least_end = std::min(least_end, end);
    }
  };
  tree_.walk(ray, kNear, 0.0, add, [&end] { return end; });
  if (least_end < end) {  // a slanted hit in front of a less slanted one: something in between may have been left out
    const double last = end;
    survey = {};
    tree_.walk(ray, kNear, 0.0, add, [last] { return last; });
  }
  if (survey.closest != kMiss) {
    const u32 closest_id = found[survey.closest].id;
    std::erase_if(found, [end](const Candidate& c) { return c.crossing.low > end; });
    for (u32 i = 0; i < found.size(); ++i) {
      if (found[i].id == closest_id) survey.closest = i;
    }
  }
  return survey;
}

SceneOracle::Survey SceneOracle::survey_all(const Ray& ray) const {
  Survey survey;
  if (!is_valid(ray)) return survey;
  std::vector<Candidate>& found = survey.candidates;
  tree_.walk(
      ray, kNear, 0.0, [&](u32 id) { consider(ray, id, found); }, [&ray] { return double{ray.tmax}; });
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.crossing.t < b.crossing.t || (a.crossing.t == b.crossing.t && a.id < b.id);
  });
  for (u32 i = 0; i < found.size() && survey.closest == kMiss; ++i) {
    if (found[i].counts) survey.closest = i;
  }
  return survey;
}

RayClass SceneOracle::class_of(const Survey& survey) {
  RayClass result = RayClass::strict;
  for (u32 i = 0; i < survey.candidates.size(); ++i) {
    const Candidate& candidate = survey.candidates[i];
    RayClass found = candidate.strict() ? RayClass::strict : RayClass::near;
    if (candidate.on_boundary()) {
      found = RayClass::boundary;
    } else if (candidate.strict() && i != survey.closest) {
      found = is_tie(survey.candidates[survey.closest].crossing, candidate.crossing) ? RayClass::tie : RayClass::near;
    }
    result = std::max(result, found);
  }
  return result;
}

RayClass SceneOracle::class_of_occlusion(const std::vector<Candidate>& candidates) {
  RayClass result = RayClass::strict;
  for (const Candidate& candidate : candidates) {
    if (candidate.strict()) return RayClass::strict;
    result = std::max(result, candidate.on_boundary() ? RayClass::boundary : RayClass::near);
  }
  return result;
}

Answer SceneOracle::closest(const Ray& ray) const {
  const Survey survey = survey_front(ray);
  Answer answer;
  answer.hit = miss_of(ray);
  answer.ray_class = class_of(survey);
  if (survey.closest == kMiss) return answer;
  const Candidate& first = survey.candidates[survey.closest];
  answer.hit = {first.crossing.t, first.id, 0.0f, 0.0f};
  answer.precise_t = first.crossing.precise_t;
  answer.well_conditioned = first.crossing.high - first.crossing.low < 2.0 * kWell * std::abs(answer.precise_t);
  for (const Candidate& candidate : survey.candidates) {
    if (candidate.counts && is_tie(first.crossing, candidate.crossing)) {
      answer.ties.push_back({candidate.id, candidate.crossing.position});
    }
  }
  std::sort(answer.ties.begin(), answer.ties.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return answer;
}

Occlusion SceneOracle::occluded(const Ray& ray) const {
  if (!is_valid(ray)) return {};
  std::vector<Candidate> found;
  Occlusion result;
  double end = ray.tmax;
  const auto add = [&](u32 id) {
    if (!consider(ray, id, found)) return;
    result.occluded = result.occluded || found.back().counts;
    if (found.back().strict()) end = -kInfinity;  // nothing can change the answer any more
  };
  tree_.walk(ray, kNear, 0.0, add, [&end] { return end; });
  result.ray_class = class_of_occlusion(found);
  return result;
}

Judgement SceneOracle::judge(const Ray& ray, const Hit& given) const {
  const Answer answer = closest(ray);
  if (given.id != answer.hit.id) return {.verdict = verdict(ray, given), .ray_class = answer.ray_class};
  Judgement result{Verdict::right, answer.ray_class};
  if (answer.is_hit()) {
    const double error = std::abs(double{given.t} - answer.precise_t) / ulp_at(answer.precise_t);
    result.t_ulps = is_finite(given.t) ? error : kInfinity;
    result.well_conditioned = answer.well_conditioned;
  }
  return result;
}

Verdict SceneOracle::verdict(const Ray& ray, const Hit& given) const {
  const Survey survey = survey_all(ray);
  if (given.id == kMiss) return verdict_on_passing(ray, survey, kInfinity);
  const auto found = std::find_if(survey.candidates.begin(), survey.candidates.end(),
                                  [&](const Candidate& c) { return c.id == given.id; });
  const bool any_hit = survey.closest != kMiss;
  if (found == survey.candidates.end()) return any_hit ? Verdict::wrong_id : Verdict::false_hit;
  if (!any_hit) return Verdict::near;
  const Candidate& first = survey.candidates[survey.closest];
  if (found->counts && is_tie(first.crossing, found->crossing)) {
    const bool same = first.on_boundary() && found->on_boundary() &&
                      compare_distances(ray, triangle(first.id), triangle(found->id)) == 0;
    return same ? Verdict::boundary : Verdict::tie;
  }
  if (found->crossing.low <= first.crossing.high) return Verdict::near;
  return verdict_on_passing(ray, survey, found->crossing.low);
}

Verdict SceneOracle::verdict_on_passing(const Ray& ray, const Survey& survey, double end) const {
  Verdict excuse = Verdict::boundary;
  for (const Candidate& passed : survey.candidates) {  // along the ray
    if (!passed.counts || passed.crossing.high >= end) continue;
    if (passed.strict()) return Verdict::false_miss;
    if (passed.sure && is_sealed(ray, passed.id, passed.crossing.radius, end, scene_, tree_)) return Verdict::leak;
    if (!passed.sure || !passed.on_boundary()) excuse = Verdict::near;
  }
  return excuse;
}

Judgement SceneOracle::judge_occluded(const Ray& ray, bool given) const {
  const Occlusion answer = occluded(ray);
  if (given == answer.occluded) return {Verdict::right, answer.ray_class};
  const Survey survey = survey_all(ray);
  if (!given) return {verdict_on_passing(ray, survey, kInfinity), answer.ray_class};
  return {survey.candidates.empty() ? Verdict::false_hit : Verdict::near, answer.ray_class};
}

}  // namespace raywalk::oracle
