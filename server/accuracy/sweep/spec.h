// What a measurement of accuracy is asked for.
#pragma once
#include <string>
#include <vector>

#include "server/catalog/build_options.h"
#include "server/catalog/scenes.h"

namespace raywalk::accuracy {

/// Where the rays of a list come from.
enum class RayKind {
  primary,  // through the pixels of walkthrough frames
  shadow,   // from what those hit to a lamp; any hit
  diffuse,  // from what those hit, bounced with a cosine density
  random,   // from points in the scene's bounds, in all directions
  edge,     // near triangles, at points of their edges
  vertex,   // near triangles, at their vertices
};
constexpr RayKind kAllRayKinds[] = {RayKind::primary, RayKind::shadow, RayKind::diffuse,
                                    RayKind::random,  RayKind::edge,   RayKind::vertex};
const char* name_of(RayKind kind);
/// They leave a surface, so that the knob `spawn` counts.
constexpr bool is_spawned(RayKind kind) {
  return kind == RayKind::shadow || kind == RayKind::diffuse;
}

struct SweepTechnique {
  std::string structure, traversal;
  GivenOptions options = {};  // of the builder

  bool operator==(const SweepTechnique&) const = default;
};

struct AccuracySpec {
  std::string scene;  // empty: the hard cases alone
  bool hard_cases = true;
  std::vector<SweepTechnique> techniques;  // empty: all of the device but baselines and brute
  std::vector<GivenOptions> knob_sets;     // empty: see knob_sets_of
  std::vector<RayKind> classes;
  u64 rays = 0;        // of a class; 0: by the device and `quick`
  bool quick = false;  // fewer rays, launches and combinations of knobs
  u64 seed = 1;
  double time_limit_s = 3600;

  bool operator==(const AccuracySpec&) const = default;
};

/// Options of a traversal's kernel that trade accuracy for speed; the others are of its compiler.
bool is_knob(const std::string& name);

/// The sets of knobs to measure a traversal with, the strict one first. Without sets of the spec: every intersector
/// with every slab test, in a quick sweep one of them changed at a time; and each spawn offset, the rest strict. A set
/// of the spec that names an option which the traversal lacks is left out.
std::vector<GivenOptions> knob_sets_of(const AccuracySpec& spec, const TraversalInfo& traversal);

/// Fills in the default techniques. Throws Refusal with pointers under /spec for a scene,
/// technique or option that does not exist, and a knob set that no technique has.
AccuracySpec checked(AccuracySpec spec, const Scenes& scenes, const std::vector<KindInfo>& kinds);

}  // namespace raywalk::accuracy
