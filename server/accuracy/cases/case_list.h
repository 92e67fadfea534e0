// The cases as functions, each in the file of its theme.
#pragma once
#include <vector>

#include "server/accuracy/cases/exam.h"

namespace raywalk::accuracy {

/// Of which techniques a case says something.
enum class Concerns {
  all,
  spatial,   // all that do not test every triangle
  counters,  // those of them whose work is counted
};

struct HardCase {
  u32 number;
  std::string_view title;
  Concerns concerns;
  void (*run)(Exam& exam);
};

/// By number.
const std::vector<HardCase>& hard_cases();

// edges.cpp
void aimed_at_edges(Exam& exam);
void aimed_at_vertices(Exam& exam);
void spiky_sphere(Exam& exam);
// corners.cpp
void split_quad(Exam& exam);
void fans(Exam& exam);
void terrain(Exam& exam);
void nested_boxes(Exam& exam);
void t_junction(Exam& exam);
// axes.cpp
void in_face_planes(Exam& exam);
void along_box_edges(Exam& exam);
void signed_zeros(Exam& exam);
void coplanar_rays(Exam& exam);
void one_flat_quad(Exam& exam);
void lattice_of_cubes(Exam& exam);
void lattice_directions(Exam& exam);
// structures.cpp
void vertical_rays(Exam& exam);
void many_cells(Exam& exam);
void steps_of_a_walk(Exam& exam);
void stretched_scenes(Exam& exam);
void node_formats(Exam& exam);
void identical_triangles(Exam& exam);
void shrinking_triangles(Exam& exam);
// degenerate.cpp
void hardly_any_triangles(Exam& exam);
void invalid_rays(Exam& exam);
void broken_vertices(Exam& exam);
void degenerate_triangles(Exam& exam);
void ends_of_the_interval(Exam& exam);
void duplicate_triangles(Exam& exam);
// scales.cpp
void far_from_the_origin(Exam& exam);
void scaled_scenes(Exam& exam);
void sliver_triangles(Exam& exam);
void needle_triangle(Exam& exam);
void origins_far_away(Exam& exam);
void direction_lengths(Exam& exam);
// spawned.cpp
void spawned_at_all_sizes(Exam& exam);
void close_shells(Exam& exam);
void seen_from_afar(Exam& exam);
void spawned_far_from_the_origin(Exam& exam);
// shading.cpp
void terminator(Exam& exam);
void glass_and_mirrors(Exam& exam);

}  // namespace raywalk::accuracy
