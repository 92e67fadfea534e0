// The table of the hard cases, and the loop over cases and techniques.
#include <algorithm>

#include "server/accuracy/cases/case_list.h"
#include "server/device/knobs.h"
#include "server/system/stopwatch.h"

namespace raywalk::accuracy {
namespace {

/// Triangle tests of which the strict cases hold.
constexpr std::string_view kStrictIntersectors[] = {"watertight", "exact"};

double value_of(const OptionValues& options, std::string_view name) {
  const auto found = options.find(name);
  return found == options.end() ? 0.0 : found->second;
}

std::string why_not(const HardCase& hard_case, const Exam& exam) {
  if (hard_case.concerns != Concerns::all && exam.is_brute()) return "every triangle is tested for every ray";
  if (hard_case.concerns == Concerns::counters && !exam.can_count()) return "its work is not counted";
  return {};
}

/// Options of the builder that a triangle test needs.
OptionValues records_for(const KindInfo& kind, std::string_view intersector) {
  const auto option = std::ranges::find(kind.options, std::string_view("triangles"), &Option::name);
  if (intersector != "baldwin-weber" || option == kind.options.end()) return {};
  const auto choice = std::ranges::find(option->choices, std::string_view("transforms"));
  return {{"triangles", static_cast<double>(choice - option->choices.begin())}};
}

}  // namespace

const std::vector<HardCase>& hard_cases() {
  using enum Concerns;
  static const std::vector<HardCase> cases = {
      {1, "rays at edges", all, aimed_at_edges},
      {2, "rays at vertices", all, aimed_at_vertices},
      {3, "sphere with spikes", all, spiky_sphere},
      {4, "quad, ray at its diagonal", all, split_quad},
      {5, "fans of up to 1,024 triangles", all, fans},
      {6, "terrain of whole heights, rays straight down", all, terrain},
      {7, "nested boxes, rays at outer vertices", all, nested_boxes},
      {8, "T-junction", all, t_junction},
      {9, "rays in a face plane of boxes", all, in_face_planes},
      {10, "rays along an edge of boxes", all, along_box_edges},
      {11, "directions of -0 and +0", all, signed_zeros},
      {12, "work of vertical rays on an axis-aligned mesh", counters, vertical_rays},
      {13, "rays in the plane of a triangle", all, coplanar_rays},
      {14, "one flat quad, up to 1e6 away", all, one_flat_quad},
      {15, "rays in the planes of 8^3 cubes", all, lattice_of_cubes},
      {16, "lattice origins, directions in {-3..3}^3", all, lattice_directions},
      {17, "walks of up to 16,384 cells", spatial, many_cells},
      {18, "steps of a long walk", counters, steps_of_a_walk},
      {19, "extents 1:1:1e6, a teapot in a stadium", all, stretched_scenes},
      {20, "formats of nodes", spatial, node_formats},
      {21, "1e5 identical triangles", all, identical_triangles},
      {22, "triangles of size 2^-k", all, shrinking_triangles},
      {23, "no triangle, one, only degenerate ones", all, hardly_any_triangles},
      {24, "sphere 10^k from the origin", all, far_from_the_origin},
      {25, "scene of any scale", all, scaled_scenes},
      {26, "slivers 1e6:1", all, sliver_triangles},
      {27, "needle, distance within its vertices'", all, needle_triangle},
      {28, "origins 1e5 away", all, origins_far_away},
      {29, "directions of any length", all, direction_lengths},
      {30, "invalid rays", all, invalid_rays},
      {31, "vertices that are no numbers", all, broken_vertices},
      {32, "points and lines as triangles", all, degenerate_triangles},
      {33, "hits at the ends of the interval", all, ends_of_the_interval},
      {34, "duplicate triangles: the lowest id", all, duplicate_triangles},
      {35, "spawned rays at sizes 1e-8 to 1e8", all, spawned_at_all_sizes},
      {36, "spawned rays between shells 4e-5 apart", all, close_shells},
      {37, "shadow of a rectangle seen from afar", all, seen_from_afar},
      {38, "spawned rays far from the origin", all, spawned_far_from_the_origin},
      {39, "terminator of a coarse sphere", all, terminator},
      {40, "glass at the critical angle, facing mirrors", all, glass_and_mirrors},
  };
  return cases;
}

const std::vector<CaseTitle>& case_titles() {
  static const std::vector<CaseTitle> titles = [] {
    std::vector<CaseTitle> all;
    for (const HardCase& hard_case : hard_cases()) all.push_back({hard_case.number, hard_case.title});
    return all;
  }();
  return titles;
}

std::vector<Technique> techniques_of(const Device& device) {
  std::vector<Technique> techniques;
  for (const KindInfo& kind : device.kinds()) {
    for (const TraversalInfo& traversal : kind.traversals) {
      if (traversal.baseline) continue;
      const auto option = std::ranges::find(traversal.options, std::string_view("intersector"), &Option::name);
      if (option == traversal.options.end()) techniques.push_back({kind.name, traversal.name});
      for (std::size_t i = 0; option != traversal.options.end() && i < option->choices.size(); ++i)
        techniques.push_back({kind.name,
                              traversal.name,
                              records_for(kind, option->choices[i]),
                              {{"intersector", static_cast<double>(i)}}});
    }
  }
  return techniques;
}

bool is_strict(const Technique& technique) {
  if (technique.structure == "embree") return false;
  if (value_of(technique.kernel, "slab") != 0 || value_of(technique.kernel, "spawn") != 0) return false;
  const auto row = static_cast<std::size_t>(value_of(technique.kernel, "intersector"));
  return row < intersector_rows().size() &&
         std::ranges::find(kStrictIntersectors, intersector_rows()[row].name) != std::end(kStrictIntersectors);
}

std::vector<CaseOutcome> run_hard_cases(const OnDevice& on_device, const SuiteSpec& spec,
                                        const std::function<void(double fraction, const std::string& what)>& report) {
  std::vector<const HardCase*> chosen;
  for (const HardCase& hard_case : hard_cases())
    if (spec.numbers.empty() || std::ranges::find(spec.numbers, hard_case.number) != spec.numbers.end())
      chosen.push_back(&hard_case);
  std::vector<CaseOutcome> outcomes;
  const std::size_t total = chosen.size() * spec.techniques.size();
  CaseStore store;
  for (const HardCase* hard_case : chosen) {
    for (const Technique& technique : spec.techniques) {
      report(static_cast<double>(outcomes.size()) / static_cast<double>(total),
             std::to_string(hard_case->number) + " " + std::string(hard_case->title) + ": " + technique.structure +
                 "/" + technique.traversal);
      CaseOutcome outcome;
      outcome.number = hard_case->number;
      outcome.title = hard_case->title;
      outcome.technique = technique;
      const Stopwatch watch;
      Exam exam(on_device, spec, technique, store, outcome);
      outcome.why_not = why_not(*hard_case, exam);
      try {
        if (outcome.why_not.empty()) hard_case->run(exam);
      } catch (const KernelRefused& refused) {
        outcome.why_not = refused.what();
      }
      outcome.ms = watch.ms();
      outcomes.push_back(std::move(outcome));
    }
    store.clear();
  }
  return outcomes;
}

}  // namespace raywalk::accuracy
