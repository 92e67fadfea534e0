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
  double precise_t = 0;           // the same with an error of at most 2^-12 ulp; meaningful with a hit
  bool well_conditioned = false;  // as in Judgement
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

/// Safe to ask from several threads at once.
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
  /// A triangle that a ray within the near radius may meet inside the interval.
  struct Candidate {
    u32 id;
    Crossing crossing;
    bool counts;  // met inside the interval, by the exact distance
    bool sure;    // and no rounding takes it out of the interval

    bool strict() const { return sure && crossing.position == Position::inside && !crossing.near; }
    bool on_boundary() const { return crossing.position != Position::inside && crossing.position != Position::outside; }
  };
  struct Survey {
    std::vector<Candidate> candidates;
    u32 closest = kMiss;  // place of the exact closest hit among them
  };
  SceneView scene_;
  BeamTree tree_;

  const Corners& triangle(u32 id) const { return scene_.corners()[id]; }
  /// Appends the triangle if it is a candidate; true if so.
  bool consider(const Ray& ray, u32 id, std::vector<Candidate>& candidates) const;
  /// All candidates that are not clearly behind the closest hit.
  Survey survey_front(const Ray& ray) const;
  /// All candidates in the interval.
  Survey survey_all(const Ray& ray) const;
  static RayClass class_of(const Survey& survey);
  static RayClass class_of_occlusion(const std::vector<Candidate>& candidates);
  Verdict verdict(const Ray& ray, const Hit& given) const;
  /// On an answer that passes all that counts and lies clearly before `end`.
  Verdict verdict_on_passing(const Ray& ray, const Survey& survey, double end) const;
};

}  // namespace raywalk::oracle
