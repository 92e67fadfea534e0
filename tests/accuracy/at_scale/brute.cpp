// Closest hits by each structure against brute force with the same triangle test, bit for bit.
#include <map>

#include "server/accuracy/cases/hex.h"
#include "server/accuracy/cases/trial.h"
#include "server/device/knobs.h"
#include "server/system/stopwatch.h"
#include "tests/accuracy/at_scale/run.h"
#include "tests/accuracy/at_scale/workers.h"

namespace raywalk::at_scale {
namespace {

using accuracy::Mesh;
using accuracy::Technique;

constexpr u64 kBatch = u64{1} << 16;  // rays at once

using MakeRays = std::vector<Ray> (*)(u32 seed, u32 count, const Mesh& mesh);
constexpr MakeRays kRays[] = {
    [](u32 seed, u32 count, const Mesh& mesh) { return accuracy::random_rays(seed, count, accuracy::bounds_of(mesh)); },
    [](u32 seed, u32 count, const Mesh& mesh) { return accuracy::edge_rays(seed, count, mesh); },
    [](u32 seed, u32 count, const Mesh& mesh) { return accuracy::vertex_rays(seed, count, mesh); },
};

/// Techniques that must agree: a place in Run::techniques of brute force, and of those that use the same triangle test.
struct Group {
  std::size_t brute;
  std::vector<std::size_t> others;
};

struct Subject {
  Mesh mesh;
  std::vector<accuracy::StructureRef> structures;  // by technique
};

u32 intersector_of(const Technique& technique) {
  return knobs_of(technique.kernel).intersector;
}

std::vector<Group> groups_of(const std::vector<Technique>& techniques) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    if (techniques[i].structure != accuracy::kBruteForce) continue;
    Group group{i, {}};
    for (std::size_t j = 0; j < techniques.size(); ++j)
      if (j != i && intersector_of(techniques[j]) == intersector_of(techniques[i])) group.others.push_back(j);
    groups.push_back(std::move(group));
  }
  return groups;
}

Subject subject_of(Run& run, Mesh mesh) {
  Subject subject{std::move(mesh), {}};
  const accuracy::SceneBlob scene = accuracy::scene_of(subject.mesh);
  std::map<std::pair<std::string, OptionValues>, accuracy::StructureRef> built;
  for (const Technique& technique : run.techniques) {
    accuracy::StructureRef& structure = built[{technique.structure, technique.options}];
    if (!structure) {
      structure =
          run.queue.run([&](Device& device) { return device.build(scene, technique.structure, technique.options); });
    }
    subject.structures.push_back(structure);
  }
  return subject;
}

/// What one worker found of each technique.
class Comparison {
 public:
  Comparison() = default;
  Comparison(const Run& run, const std::vector<Group>& groups)
      : run_(&run), groups_(&groups), rows_(run.techniques.size()) {}

  void compare(const Subject& subject, const std::vector<Ray>& rays) {
    for (const Group& group : *groups_) {
      const std::vector<Hit> expected = closest(group.brute, subject, rays);
      for (const std::size_t other : group.others) {
        const std::vector<Hit> hits = closest(other, subject, rays);
        for (std::size_t i = 0; i < hits.size(); ++i)
          if (!accuracy::same_bits(hits[i], expected[i])) fail(rows_[other], rays[i], hits[i], expected[i]);
      }
    }
  }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  const Run* run_ = nullptr;
  const std::vector<Group>* groups_ = nullptr;
  std::vector<Row> rows_;

  /// Counts the rays, and the time on the device's thread.
  std::vector<Hit> closest(std::size_t place, const Subject& subject, const std::vector<Ray>& rays) {
    const Technique& technique = run_->techniques[place];
    const RayJob job{subject.structures[place], technique.traversal, rays, technique.kernel};
    rows_[place].rays += rays.size();
    return run_->queue.run([&](Device& device) {
      const Stopwatch watch;
      std::vector<Hit> hits = device.closest(job);
      rows_[place].seconds += watch.ms() * 1e-3;
      return hits;
    });
  }
  static void fail(Row& row, const Ray& ray, const Hit& given, const Hit& expected) {
    if (row.failures++ != 0) return;
    row.first_failure =
        accuracy::text_of(given) + ", by brute force " + accuracy::text_of(expected) + ": " + accuracy::text_of(ray);
  }
};

std::vector<Row> compare_all(const Run& run, u32 worker, const std::vector<Subject>& subjects,
                             const std::vector<Group>& groups, u64 rays_of_each) {
  Comparison comparison(run, groups);
  std::mt19937 seeds(static_cast<u32>(run.seed_of(worker)));
  for (u64 done = 0; done < rays_of_each; done += kBatch) {
    const u32 now = static_cast<u32>(std::min(kBatch, rays_of_each - done));
    for (const Subject& subject : subjects)
      for (const MakeRays make : kRays) comparison.compare(subject, make(seeds(), now, subject.mesh));
  }
  return comparison.rows();
}

}  // namespace

void ask_brute(Run& run) {
  const std::vector<Group> groups = groups_of(run.techniques);
  std::vector<Subject> subjects;
  for (Mesh mesh : {accuracy::icosphere(3), accuracy::random_soup(7, 1000), accuracy::subdivided_box(9)})
    subjects.push_back(subject_of(run, std::move(mesh)));
  const double compared = static_cast<double>(run.techniques.size() - groups.size());
  const double lists = static_cast<double>(subjects.size() * std::size(kRays));
  const u64 rays_of_each = run.part_of(1e9 / compared / lists);
  const auto found = run_workers(run.settings.threads,
                                 [&](u32 worker) { return compare_all(run, worker, subjects, groups, rays_of_each); });
  for (std::size_t place = 0; place < run.techniques.size(); ++place) {
    Row row{.part = "brute", .technique = name_of(run.techniques[place])};
    for (const std::vector<Row>& of_worker : found) {
      row.rays += of_worker[place].rays;
      row.failures += of_worker[place].failures;
      row.seconds += of_worker[place].seconds;
      if (row.first_failure.empty()) row.first_failure = of_worker[place].first_failure;
    }
    if (run.techniques[place].structure == accuracy::kBruteForce) row.note = "the others are compared with it";
    run.table.add(row);
  }
}

}  // namespace raywalk::at_scale
