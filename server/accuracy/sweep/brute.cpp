// One pass over all triangles for each intersector.
#include "server/accuracy/sweep/brute.h"

#include <algorithm>

namespace raywalk::accuracy {
namespace {

constexpr const char* kBrute = "brute";
constexpr const char* kIntersector = "intersector";

/// Tests of one pass: about a second on two cores, and on a GPU.
u64 affordable_tests(const Run& run) {
  const u64 tests = run.on_gpu() ? 20'000'000'000u : 100'000'000u;
  return run.spec.quick ? tests / 5 : tests;
}

const KindInfo* brute_of(const std::vector<KindInfo>& kinds) {
  const auto found = std::ranges::find(kinds, kBrute, &KindInfo::name);
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace

BruteForce::BruteForce(const Run& run, ScenePtr scene, const RayList& list) : run_(run), scene_(std::move(scene)) {
  const u64 triangles = std::max<u64>(1, scene_->info.triangles);
  const u64 wanted = std::clamp<u64>(affordable_tests(run) / triangles, 1, list.rays.size());
  stride_ = list.rays.size() / wanted;
  for (u64 i = 0; i < list.rays.size(); i += stride_) rays_.push_back(list.rays[i]);
}

const std::vector<Hit>& BruteForce::answers(const GivenOption& intersector) {
  std::vector<Hit>& hits = answers_[intersector];
  if (!hits.empty()) return hits;
  const KindInfo& kind = *brute_of(run_.place.structures.kinds());
  const TraversalInfo& traversal = kind.traversals.front();
  const OptionValues kernel = complete_options(kind, traversal, {{kIntersector, intersector}}, "");
  const StructureRecord structure =
      run_.place.structures.build_and_wait(scene_, kBrute, builder_options(kind, {}, kernel));
  const RayJob job{structure.structure, traversal.name, rays_, kernel};
  hits = run_.place.queue.run([&](Device& device) { return device.closest(job); });
  return hits;
}

void BruteForce::compare(const Combination& combination, const std::vector<Hit>& hits, SweepErrors& errors) {
  const auto intersector = combination.knobs.find(kIntersector);
  if (intersector == combination.knobs.end() || brute_of(run_.place.structures.kinds()) == nullptr) return;
  const std::vector<Hit>& expected = answers(intersector->second);
  errors.brute_rays = rays_.size();
  for (u64 i = 0; i < rays_.size(); ++i) {
    const Hit& hit = hits[i * stride_];
    errors.brute_mismatches += bits_of(hit.t) != bits_of(expected[i].t) || hit.id != expected[i].id;
  }
}

}  // namespace raywalk::accuracy
