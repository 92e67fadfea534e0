// Rays through a scene, and the properties that their answers must have.
#pragma once
#include "server/accuracy/cases/exam.h"
#include "server/accuracy/oracle/scene_oracle.h"

namespace raywalk::accuracy {

/// Rays with what exact arithmetic says of each. Made once for all techniques.
struct Trial {
  std::string name;
  Mesh mesh;
  SceneBlob scene;
  std::vector<Ray> rays;
  std::unique_ptr<oracle::SceneOracle> oracle;
  std::vector<oracle::Answer> answers;
};

/// Invalid rays are left out.
std::shared_ptr<const Trial> make_trial(std::string name, const Mesh& mesh, std::vector<Ray> rays);

/// Each answer is acceptable to the oracle, and a ray is occluded exactly when it has a closest hit. `options` go to
/// the builder where it has them.
void judge(Exam& exam, const Trial& trial, const OptionValues& options = {});

/// The closest hits are those of brute force, bit for bit; only asked of strict techniques.
void same_as_brute(Exam& exam, const Trial& trial, const OptionValues& options = {});

/// Both.
void judge_and_compare(Exam& exam, const Trial& trial, const OptionValues& options = {});

/// Each ray meets the mesh exactly `times` times: as many closest hits one behind the other, then none. With brute
/// force the order of the triangles does not matter either, so that none of equal distance hides another.
void meets(Exam& exam, const SceneBlob& scene, const std::vector<Ray>& rays, u32 times = 1);

/// No ray meets anything.
void misses(Exam& exam, const SceneBlob& scene, const std::vector<Ray>& rays);

/// The answers to both lists are the same, bit for bit.
void same_answers(Exam& exam, const StructureRef& structure, const std::vector<Ray>& rays, const std::vector<Ray>& as,
                  const std::string& what);

bool same_bits(const Hit& a, const Hit& b);
Mesh mesh_of(const SceneBlob& scene);
/// The given triangles of the mesh, and all that share a vertex with one of them.
Mesh ring_around(const Mesh& mesh, const std::vector<u32>& ids);

}  // namespace raywalk::accuracy
