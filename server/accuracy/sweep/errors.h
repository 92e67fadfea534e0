// How wrong a technique is on one list of rays, by the oracle.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "server/accuracy/oracle/figures.h"
#include "server/accuracy/oracle/scene_oracle.h"
#include "server/accuracy/sweep/ray_lists.h"
#include "server/accuracy/sweep/vertex_fans.h"

namespace raywalk::accuracy {

struct SweepErrors {
  oracle::Figures figures;         // of all judged rays
  u64 wrong = 0;                   // rays with at least one fault: not acceptable, a self-hit, a double hit or NaN
  std::optional<u64> self_hits;    // rays that meet the triangle which they leave; only of spawned rays
  std::optional<u64> double_hits;  // see is_double_hit; only of rays aimed at edges and vertices
  u64 nan_outputs = 0;
  u64 brute_rays = 0;  // compared with brute force by the same intersector; 0: not compared
  u64 brute_mismatches = 0;
};

/// A technique's answers to a list of rays.
struct Answers {
  std::vector<Hit> hits;     // closest, in the ray's interval
  std::vector<u8> occluded;  // of any-hit lists, else empty
  std::vector<Hit> beyond;   // of `continued_rays`; empty where double hits are not looked for
};

/// Each ray from just behind its hit to kDoubleHitUlps farther; what missed stays a miss.
constexpr u32 kDoubleHitUlps = 16;
std::vector<Ray> continued_rays(const std::vector<Ray>& rays, const std::vector<Hit>& hits);

/// Triangles `first` and `second` are hits a few ulps apart of the same ray, on one surface that exact arithmetic
/// passes once: not both are strictly met, and the surface does not turn back between them as at a silhouette, where a
/// ray that is moved by a rounding may pass it three times.
bool is_double_hit(const Ray& ray, SceneView scene, u32 first, u32 second, const VertexFans& fans);

/// Judges answers to one list. The verdict on an answer is remembered: techniques that agree cost once.
class Judge {
 public:
  /// All live as long as the judge. At most kMostJudged rays are judged, evenly spaced.
  Judge(const oracle::SceneOracle& oracle, SceneView scene, const VertexFans& fans, const RayList& list);
  static constexpr u64 kMostJudged = 1'000'000;

  u64 judged() const;
  /// On all processors. `report` is called again and again with the fraction done; what it throws ends the work.
  SweepErrors errors_of(const Answers& answers, const std::function<void(double fraction)>& report);

 private:
  struct Known {
    Hit hit;
    u8 occluded;
    oracle::Judgement judgement;
  };
  u64 ray_of(u64 place) const { return place * stride_; }
  const oracle::Judgement& judgement_of(u64 place, const Answers& answers);
  void add(u64 place, const Answers& answers, SweepErrors& errors);

  const oracle::SceneOracle& oracle_;
  SceneView scene_;
  const VertexFans& fans_;
  const RayList& list_;
  u64 stride_;
  std::vector<std::vector<Known>> known_;  // by place
};

}  // namespace raywalk::accuracy
