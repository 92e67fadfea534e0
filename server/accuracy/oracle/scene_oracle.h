// Exact answers for the rays of a scene, and verdicts on the answers of a kernel.
#pragma once
#include <vector>

#include "server/accuracy/oracle/beam_tree.h"
#include "server/accuracy/oracle/exact.h"
#include "server/accuracy/oracle/judgement.h"

namespace raywalk::oracle {

struct IdAtPosition {
  u32 id;
  Position position;
};

/// The closest hit in [tmin, tmax], both ends included, by exact distances.
struct Answer {
  /// t as rounded once, with the lowest id of those at this float. kMiss and tmax without a hit; u and v are 0.
  Hit hit{};
  double precise_t = 0;  // the same with an error below 2^-12 ulp; meaningful with a hit
  /// By id: all triangles met inside the interval at most kTieUlps behind the first, hit.id among them. Empty for a
  /// miss.
  std::vector<IdAtPosition> ties;
  RayClass ray_class = RayClass::strict;

  bool is_hit() const { return hit.id != kMiss; }
};

struct Occlusion {
  bool occluded = false;                  // something is met in [tmin, tmax]
  RayClass ray_class = RayClass::strict;  // strict when one strict hit decides, or nothing is near; never tie
};

/// Safe to ask from several threads at once. Costs microseconds a ray, and 2 seconds a million triangles to make.
class SceneOracle {
 public:
  /// The blob of `scene` must live as long as the oracle. Throws std::bad_alloc.
  explicit SceneOracle(SceneView scene);

  Answer closest(const Ray& ray) const;
  Occlusion occluded(const Ray& ray) const;

  /// The verdict on an answer of a kernel; any bits may stand in `given`.
  Judgement judge(const Ray& ray, const Hit& given) const;
  /// The same for an occlusion query. tie and wrong_id do not occur, nor does t_ulps.
  Judgement judge_occluded(const Ray& ray, bool given) const;

 private:
  SceneView scene_;
  BeamTree tree_;
};

}  // namespace raywalk::oracle
