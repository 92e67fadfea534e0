// One class of rays with all combinations: made, measured, judged.
#pragma once
#include "server/accuracy/sweep/run.h"

namespace raywalk::accuracy {

/// What answers are judged with.
struct Reference {
  explicit Reference(SceneView its_scene) : scene(its_scene), oracle(scene), fans(scene) {}
  SceneView scene;
  oracle::SceneOracle oracle;
  VertexFans fans;
};

/// Appends a row for each combination to `out`, or a note when the scene has no such rays. `report` gets the stage and
/// the fraction done of this class.
void run_class(Run& run, RayKind kind, const std::vector<Combination>& all, RayMaker& maker, const Reference& reference,
               AccuracyResult& out,
               const std::function<void(const std::string& stage, double fraction, bool judging)>& report);

/// Launches of each list that count.
u32 launches_of(const Run& run);

}  // namespace raywalk::accuracy
