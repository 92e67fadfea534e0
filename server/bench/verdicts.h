// What the exact oracle says of the rays on which a technique and its reference do not agree.
#pragma once
#include <optional>
#include <span>

#include "kernels/ray.h"
#include "kernels/scene_view.h"
#include "server/accuracy/oracle/scene_oracle.h"

namespace raywalk {

/// Sums over rays of one kind. Rays on which both agree are not judged.
struct RayVerdicts {
  u64 rays = 0;  // compared
  u64 judged = 0;
  // Of the technique's answers to those that were judged.
  u64 right = 0;  // or another triangle at the same distance
  u64 boundary = 0, near = 0;
  u64 leaks = 0, false_misses = 0, false_hits = 0, wrong_ids = 0;
  u64 self_hits = 0;  // shadow rays that meet the triangle which they leave; counted here alone, agreed upon or not
  u64 reference_wrong = 0;

  u64 wrong() const { return leaks + false_misses + false_hits + wrong_ids + self_hits; }
  void add(oracle::Verdict ours, oracle::Verdict reference);
  RayVerdicts& operator+=(const RayVerdicts& other);
};

/// Asks the oracle of one scene; builds it when it is first needed.
class Judge {
 public:
  explicit Judge(SceneView scene) : scene_(scene) {}

  /// On answers that differ.
  void judge(const Ray& ray, const Hit& ours, const Hit& reference, RayVerdicts& verdicts);
  void judge_occluded(const Ray& ray, bool ours, RayVerdicts& verdicts);

 private:
  SceneView scene_;
  std::optional<oracle::SceneOracle> oracle_;

  const oracle::SceneOracle& oracle();
};

}  // namespace raywalk
