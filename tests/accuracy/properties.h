// What must stay the same when the same question is put in another way, asked of one technique.
#pragma once
#include <ostream>
#include <string_view>

#include "server/accuracy/cases/trial.h"

namespace raywalk::accuracy {

struct Property {
  const char* name;
  void (*holds)(Exam& exam);
};
inline void PrintTo(const Property& property, std::ostream* out) {
  *out << property.name;
}

/// A mesh, whose ids are its places, and rays at it: at random, at edges and at vertices.
struct Shape {
  std::string name;
  Mesh mesh;
  std::vector<Ray> rays;
  bool sealed;  // a closed mesh seen from inside: each ray meets one triangle of it
};
const std::vector<Shape>& shapes();

/// The shape's scene, made at its first use.
const SceneBlob& scene_of(Exam& exam, const Shape& shape);

/// By its name on the wire; empty for Embree, which has its own.
std::string_view intersector_of(const Technique& technique);

/// Whether a hit lies in its box, so that every traversal finds what brute force finds. Boxes and cells are padded for
/// the errors of the watertight test. Those of the exact one and of the double one are smaller; so are Baldwin-Weber's
/// while no coordinate is larger than the scene, as in the shapes. Where a ray grazes a triangle Moeller-Trumbore's t
/// has no bound: of 80,000 such rays 26 differ from brute force in a kd-tree. Of Embree's we know none.
bool hits_stay_in_boxes(const Exam& exam);

/// True, after the exam has been told, for a technique of which only brute force could keep a property.
bool may_lose_hits(Exam& exam);

// properties_lists.cpp
void repeated_runs(Exam& exam);
void alone_or_in_a_list(Exam& exam);
void as_by_brute_force(Exam& exam);
void occluded_when_hit(Exam& exam);
void split_interval(Exam& exam);
// properties_moved.cpp
void mirrored(Exam& exam);
void permuted_axes(Exam& exam);
void turned_windings(Exam& exam);
void shuffled_triangles(Exam& exam);
void translated(Exam& exam);
void far_geometry(Exam& exam);

}  // namespace raywalk::accuracy
