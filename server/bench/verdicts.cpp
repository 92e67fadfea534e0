// Verdicts into counts.
#include "server/bench/verdicts.h"

namespace raywalk {

using oracle::Verdict;

void RayVerdicts::add(Verdict ours, Verdict reference) {
  ++judged;
  reference_wrong += !oracle::is_acceptable(reference);
  switch (ours) {
    case Verdict::right:
    case Verdict::tie:
      ++right;
      break;
    case Verdict::boundary:
      ++boundary;
      break;
    case Verdict::near:
      ++near;
      break;
    case Verdict::leak:
      ++leaks;
      break;
    case Verdict::false_miss:
      ++false_misses;
      break;
    case Verdict::wrong_id:
      ++wrong_ids;
      break;
    case Verdict::false_hit:
      ++false_hits;
      break;
  }
}

RayVerdicts& RayVerdicts::operator+=(const RayVerdicts& other) {
  rays += other.rays;
  judged += other.judged;
  right += other.right;
  boundary += other.boundary;
  near += other.near;
  leaks += other.leaks;
  false_misses += other.false_misses;
  false_hits += other.false_hits;
  wrong_ids += other.wrong_ids;
  self_hits += other.self_hits;
  reference_wrong += other.reference_wrong;
  return *this;
}

void Judge::judge(const Ray& ray, const Hit& ours, const Hit& reference, RayVerdicts& verdicts) {
  verdicts.add(oracle().judge(ray, ours).verdict, oracle().judge(ray, reference).verdict);
}

void Judge::judge_occluded(const Ray& ray, bool ours, RayVerdicts& verdicts) {
  verdicts.add(oracle().judge_occluded(ray, ours).verdict, oracle().judge_occluded(ray, !ours).verdict);
}

const oracle::SceneOracle& Judge::oracle() {
  if (!oracle_) oracle_.emplace(scene_);
  return *oracle_;
}

}  // namespace raywalk
