// Brute force on a part of a list: what a structure must not change.
#pragma once
#include <map>
#include <utility>

#include "server/accuracy/sweep/errors.h"
#include "server/accuracy/sweep/run.h"

namespace raywalk::accuracy {

/// For one list of rays. A test of every triangle is dear, so few rays are compared, evenly spaced.
class BruteForce {
 public:
  /// All outlive it.
  BruteForce(const Run& run, ScenePtr scene, const RayList& list);

  /// Fills in `brute_rays` and `brute_mismatches`: other bits of t, or another id, than brute force by the intersector
  /// of the combination. Left alone where there is no such brute force.
  void compare(const Combination& combination, const std::vector<Hit>& hits, SweepErrors& errors);

 private:
  const std::vector<Hit>& answers(const GivenOption& intersector);

  const Run& run_;
  ScenePtr scene_;
  std::vector<Ray> rays_;
  u64 stride_ = 1;
  std::map<GivenOption, std::vector<Hit>> answers_;  // by intersector
};

}  // namespace raywalk::accuracy
