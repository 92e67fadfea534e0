// Options, ids, one build a key, eviction under use.
#include <gtest/gtest.h>

#include <future>

#include "server/catalog/structures.h"
#include "server/system/refusal.h"
#include "tests/server/fake_device.h"
#include "tests/server/fake_scene.h"

namespace raywalk {
namespace {

using namespace std::chrono_literals;

using test::scene_named;

std::string code_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Refusal& refusal) {
    return refusal.code();
  }
  return "none";
}

class StructuresTest : public testing::Test {
 protected:
  test::FakeDevice device_;
  DeviceQueue queue_{device_};
  Structures structures_{queue_, device_.kinds()};
  ScenePtr scene_ = scene_named("a");
};

TEST(OptionValues, DefaultsRangesAndChoices) {
  test::FakeDevice device;
  const KindInfo& kind = device.kinds()[0];
  EXPECT_EQ(complete_options(kind, {}, "").at("bins"), 32);
  EXPECT_EQ(complete_options(kind, {{"split", "middle"}}, "").at("split"), 1);
  const auto code = [&](GivenOptions given) { return code_of([&] { complete_options(kind, given, ""); }); };
  EXPECT_EQ(code({{"bins", 1.0}}), "invalid_option");
  EXPECT_EQ(code({{"bins", 2.5}}), "invalid_option");
  EXPECT_EQ(code({{"bins", "many"}}), "invalid_option");
  EXPECT_EQ(code({{"split", 1.0}}), "invalid_option");
  EXPECT_EQ(code({{"split", "other"}}), "invalid_option");
  EXPECT_EQ(code({{"speed", 1.0}}), "unknown_option");
}

TEST(OptionValues, OfKernelsAreCheckedAlike) {
  test::FakeDevice device;
  const KindInfo& kind = device.kinds()[0];
  const TraversalInfo& traversal = kind.traversals[0];
  const OptionValues values = complete_options(kind, traversal, {{"registers", 40.0}}, "/kernel");
  EXPECT_EQ(values, (OptionValues{{"registers", 40}, {"test", 0}, {"block", 128}}));
  try {
    complete_options(kind, traversal, {{"cap", 1.0}}, "/kernel");
    FAIL() << "there is no such option";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.code(), "unknown_option");
    EXPECT_EQ(refusal.offences().front().pointer, "/kernel/cap");
    EXPECT_EQ(refusal.known_names(), (std::vector<std::string>{"registers", "test", "block"}));
    EXPECT_NE(std::string(refusal.what()).find("bvh/while-while"), std::string::npos);
  }
}

TEST(OptionValues, AreMultiplesOfTheirStep) {
  test::FakeDevice device;
  const KindInfo& kind = device.kinds()[0];
  const TraversalInfo& traversal = kind.traversals[0];
  EXPECT_EQ(complete_options(kind, traversal, {{"block", 96.0}}, "").at("block"), 96);
  for (const double block : {48.0, 100.0}) {
    try {
      complete_options(kind, traversal, {{"block", block}}, "/kernel");
      FAIL() << block << " is no multiple of 32";
    } catch (const Refusal& refusal) {
      EXPECT_EQ(refusal.code(), "invalid_option");
      EXPECT_EQ(refusal.offences().front().pointer, "/kernel/block");
      EXPECT_NE(std::string(refusal.what()).find("multiple of 32"), std::string::npos);
    }
  }
}

TEST(OptionValues, ChangedOnesAreShown) {
  test::FakeDevice device;
  const KindInfo& kind = device.kinds()[0];
  const auto shown = [&](GivenOptions given) {
    return changed_options(kind.options, complete_options(kind, given, ""));
  };
  EXPECT_EQ(shown({}), "");
  EXPECT_EQ(shown({{"bins", 32.0}}), "");
  EXPECT_EQ(shown({{"split", "middle"}, {"bins", 16.0}, {"cost", 1.25}}), " bins=16 cost=1.25 split=middle");
}

TEST(OptionValues, IdsNameOptionsThatAreNotTheDefault) {
  test::FakeDevice device;
  const KindInfo& kind = device.kinds()[0];
  const auto id = [&](GivenOptions given) { return structure_id("s", kind, complete_options(kind, given, "")); };
  EXPECT_EQ(id({}), "s.bvh");
  EXPECT_EQ(id({{"bins", 32.0}}), "s.bvh");
  EXPECT_EQ(id({{"bins", 16.0}}).size(), std::string("s.bvh.01234567").size());
  EXPECT_NE(id({{"bins", 16.0}}), id({{"bins", 17.0}}));
}

TEST_F(StructuresTest, OneBuildAKey) {
  device_.build_time = 30ms;
  std::vector<std::future<StructureRecord>> records;
  for (int i = 0; i < 8; ++i) {
    records.push_back(std::async(std::launch::async, [&] { return structures_.build_and_wait(scene_, "bvh", {}); }));
  }
  StructurePtr first;
  for (auto& record : records) {
    const StructurePtr structure = record.get().structure;
    ASSERT_TRUE(structure);
    if (!first) first = structure;
    EXPECT_EQ(structure, first);
  }
  EXPECT_EQ(device_.builds, 1);
}

TEST_F(StructuresTest, StatesAreTold) {
  EXPECT_EQ(code_of([&] { structures_.ready(scene_, "bvh", "/structure"); }), "structure_not_built");
  EXPECT_EQ(code_of([&] { structures_.ready(scene_, "octree", "/structure"); }), "unknown_kind");
  EXPECT_EQ(code_of([&] { structures_.ready(scene_, "b.bvh", "/structure"); }), "foreign_structure");
  EXPECT_EQ(code_of([&] { structures_.find("a.bvh"); }), "unknown_structure");
  device_.build_time = 50ms;
  EXPECT_EQ(structures_.build(scene_, "bvh", {}).state, StructureRecord::State::building);
  EXPECT_EQ(code_of([&] { structures_.ready(scene_, "bvh", "/structure"); }), "structure_not_built");
  structures_.build_and_wait(scene_, "bvh", {});
  EXPECT_TRUE(structures_.ready(scene_, "bvh", "/structure"));
  EXPECT_TRUE(structures_.ready(scene_, "a.bvh", "/structure"));
}

TEST_F(StructuresTest, AFailedBuildIsTriedAgain) {
  device_.fail_builds = true;
  EXPECT_THROW(structures_.build_and_wait(scene_, "bvh", {}), std::runtime_error);
  EXPECT_EQ(structures_.find("a.bvh").error, "it fell over");
  EXPECT_EQ(code_of([&] { structures_.ready(scene_, "bvh", "/structure"); }), "structure_not_built");
  device_.fail_builds = false;
  EXPECT_EQ(structures_.build_and_wait(scene_, "bvh", {}).state, StructureRecord::State::ready);
}

TEST_F(StructuresTest, AFullDeviceIsToldWithBothFigures) {
  device_.memory_is_full = true;
  EXPECT_THROW(structures_.build_and_wait(scene_, "bvh", {}), OutOfDeviceMemory);
  const std::string error = structures_.find("a.bvh").error;
  EXPECT_NE(error.find("2000"), std::string::npos) << error;
  EXPECT_NE(error.find("1000"), std::string::npos) << error;
  EXPECT_THROW(structures_.ready(scene_, "bvh", "/structure"), OutOfDeviceMemory);
  device_.memory_is_full = false;
  EXPECT_EQ(structures_.build_and_wait(scene_, "bvh", {}).state, StructureRecord::State::ready);
}

TEST_F(StructuresTest, ALostDeviceIsToldToTheQueue) {
  device_.is_lost = true;
  EXPECT_THROW(structures_.build_and_wait(scene_, "bvh", {}), DeviceLost);
  EXPECT_EQ(queue_.lost(), "it fell off the bus");
  EXPECT_THROW(structures_.build(scene_, "bvh", {}), DeviceLost);
}

TEST_F(StructuresTest, EvictionLeavesWhatIsInUse) {
  structures_.build_and_wait(scene_, "bvh", {});
  const StructurePtr used = structures_.ready(scene_, "bvh", "/structure");
  structures_.evict("a.bvh");
  EXPECT_EQ(code_of([&] { structures_.evict("a.bvh"); }), "unknown_structure");
  EXPECT_EQ(used->stats().references, 3u);
  EXPECT_EQ(used.use_count(), 1);
}

TEST_F(StructuresTest, AReplacedSceneTakesItsStructuresAlong) {
  structures_.build_and_wait(scene_, "bvh", {});
  const ScenePtr newer = scene_named("a");
  EXPECT_EQ(code_of([&] { structures_.ready(newer, "bvh", "/structure"); }), "structure_not_built");
  structures_.build_and_wait(newer, "embree", {});
  structures_.evict_scene("a", newer);
  EXPECT_EQ(structures_.list().size(), 1u);
  EXPECT_TRUE(structures_.ready(newer, "embree", "/structure"));
}

}  // namespace
}  // namespace raywalk
