// What must stay the same when a question is put in another way, for every structure, traversal and triangle test.
#include <cstdio>

#include "server/system/stopwatch.h"
#include "tests/accuracy/properties.h"
#include "tests/gpu/gpu.h"

namespace raywalk::accuracy {
namespace {

const Property kProperties[] = {
    {"RepeatedRuns", repeated_runs},
    {"AloneOrInAList", alone_or_in_a_list},
    {"AsByBruteForce", as_by_brute_force},
    {"OccludedWhenHit", occluded_when_hit},
    {"SplitInterval", split_interval},
    {"Mirrored", mirrored},
    {"PermutedAxes", permuted_axes},
    {"TurnedWindings", turned_windings},
    {"ShuffledTriangles", shuffled_triangles},
    {"Translated", translated},
    {"FarGeometry", far_geometry},
};

std::string name_of(const Technique& technique) {
  return technique.structure + "/" + technique.traversal + " " + std::string(intersector_of(technique));
}

std::string name_of_property(const testing::TestParamInfo<Property>& info) {
  return info.param.name;
}

/// Holds for all techniques, but for those that say why it does not apply; it applies to all strict ones.
void expect_for_all(Device& device, const Property& property) {
  const auto on_device = [&](const std::function<void(Device&)>& work) { work(device); };
  const SuiteSpec spec{techniques_of(device), {}};
  CaseStore store;
  u64 asked = 0, rays = 0;
  const Stopwatch watch;
  for (const Technique& technique : spec.techniques) {
    SCOPED_TRACE(name_of(technique));
    CaseOutcome outcome;
    outcome.technique = technique;
    Exam exam(on_device, spec, technique, store, outcome);
    property.holds(exam);
    EXPECT_EQ(outcome.failures, 0u) << "of " << outcome.rays << ": " << outcome.first_failure;
    EXPECT_EQ(outcome.rays > 0, outcome.why_not.empty());
    if (is_strict(technique)) {
      EXPECT_EQ(outcome.why_not, "");
    }
    asked += outcome.why_not.empty();
    rays += outcome.rays;
  }
  std::printf("      %-20s %3llu of %zu techniques %8llu rays %6.0f ms\n", property.name, asked, spec.techniques.size(),
              rays, watch.ms());
}

class Properties : public testing::TestWithParam<Property> {};
TEST_P(Properties, Cpu) {
  static const std::unique_ptr<Device> device = open_cpu_device(0);
  expect_for_all(*device, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Each, Properties, testing::ValuesIn(kProperties), name_of_property);

class GpuProperties : public test::GpuTest, public testing::WithParamInterface<Property> {};
TEST_P(GpuProperties, Gpu) {
  expect_for_all(gpu(), GetParam());
}
INSTANTIATE_TEST_SUITE_P(Each, GpuProperties, testing::ValuesIn(kProperties), name_of_property);

TEST(PropertyShapes, EachRayMeetsASealedOne) {
  for (const Shape& shape : shapes()) {
    if (!shape.sealed) continue;
    const SceneBlob scene = scene_of(shape.mesh);
    const oracle::SceneOracle oracle({scene->data()});
    for (const Ray& ray : shape.rays) EXPECT_TRUE(oracle.closest(ray).is_hit()) << shape.name;
  }
}

}  // namespace
}  // namespace raywalk::accuracy
