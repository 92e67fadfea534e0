// The verdicts of the oracle on answers of a kernel.
#pragma once
#include <optional>

#include "kernels/platform.h"

namespace raywalk::oracle {

/// How hard a ray is for its scene; the first that applies, from the bottom up.
enum class RayClass : u8 {
  strict,    // every decision that matters has a margin
  tie,       // two triangles at the closest hit within kTieUlps
  near,      // within the near radius something else would be hit, or the hit leaves the interval
  boundary,  // an edge or vertex is met exactly, or a triangle's plane contains the ray and its edges are touched
};
constexpr u32 kRayClasses = 4;

/// What is wrong with an answer. E is the exact closest hit inside [tmin, tmax], G the triangle that was given.
/// "Passes" means that the answer is a miss (for occlusion: false), or that G lies clearly behind the passed triangle.
/// Clearly: for no ray that is moved by up to the near radius and no t that is rounded by 2 ulps it would be otherwise.
///
///   right       G = E, or a miss and there is no E                                      (how far t is off: t_ulps)
///   tie         G is another triangle, met inside the interval, |t of G - t of E| <= 2 ulp
///   boundary    as tie, but both are met exactly in an edge or vertex at the same t; or the answer passes triangles
///               that are all met exactly in an edge or vertex where the surface is not sealed
///   near        G is met or nearly so, and not clearly behind E nor outside the interval; or the answer passes
///               triangles that the ray meets near an edge where the surface is not sealed, or near the interval's end
///   leak        the answer passes a triangle that is met in, or near, an edge or vertex where the surface is sealed:
///               every ray within the near radius meets it, so no rounding of the ray explains the answer
///   false_miss  the answer passes a triangle that is strictly met: inside, not near an edge, surely in the interval
///   wrong_id    there is an E, but G is neither met nor near, or clearly outside the interval
///   false_hit   the same when there is no E; for occlusion, true where nothing is met or near
///
/// When an answer passes several triangles, the first leak or false miss along the ray counts. A silhouette is not
/// sealed, whether or not the mesh is closed there.
enum class Verdict : u8 { right, tie, boundary, near, leak, false_miss, wrong_id, false_hit };
constexpr u32 kVerdicts = 8;

/// About 3.5 times what a triangle shows that is met head-on and reaches no farther than the hit.
constexpr double kWell = 0x1p-17;

/// Right, or as good as float32 arithmetic can tell.
constexpr bool is_acceptable(Verdict v) {
  return v <= Verdict::near;
}
const char* name_of(Verdict v);
const char* name_of(RayClass c);

struct Judgement {
  Verdict verdict = Verdict::right;
  RayClass ray_class = RayClass::strict;
  /// Error of the given t, in ulps of the exact one; none unless E was given. Infinite for NaN.
  std::optional<double> t_ulps{};
  /// The exact t changes by less than kWell of itself when the ray is moved by the near radius: it is not much smaller
  /// than the distance to the farthest vertex, and the triangle not slanted much. Only with t_ulps.
  bool well_conditioned = false;
};

}  // namespace raywalk::oracle
