// Tiers: which knobs they mean, and what given options change.
#include "server/catalog/tiers.h"

#include <gtest/gtest.h>

#include "kernels/accel/traversals.h"
#include "server/device/knobs.h"
#include "server/system/refusal.h"
#include "tests/server/fake_device.h"

namespace raywalk {
namespace {

class TiersTest : public testing::Test {
 protected:
  OptionValues options(Tier tier, const GivenOptions& given = {}) {
    return kernel_options(kind_, traversal_, tier, given, "/kernel");
  }
  std::string named(const OptionValues& values) { return changed_options(traversal_.options, values); }

  TraversalInfo traversal_{"while-while", "", false, knob_options(kKnobSlab)};
  KindInfo kind_{"bvh", "", {}, {traversal_}};
};

TEST_F(TiersTest, StrictIsTheDefaultOfEveryKnob) {
  EXPECT_EQ(options(Tier::strict), complete_options(kind_, traversal_, {}, ""));
  EXPECT_EQ(options(Tier::automatic), options(Tier::strict)) << "until it is chosen";
  EXPECT_EQ(named(options(Tier::strict)), "");
}

TEST_F(TiersTest, FastHasTheCheapTestsAndASafeSpawnOffset) {
  EXPECT_EQ(named(options(Tier::fast)), " intersector=moeller-trumbore slab=plain");
}

TEST_F(TiersTest, WhatIsGivenOverridesTheTier) {
  const OptionValues values = options(Tier::fast, {{"slab", "ize"}});
  EXPECT_EQ(named(values), " intersector=moeller-trumbore slab=ize");
  EXPECT_FALSE(is_of_tier(traversal_, Tier::fast, values));
  EXPECT_FALSE(is_of_tier(traversal_, Tier::strict, values));
  EXPECT_TRUE(is_of_tier(traversal_, Tier::fast, options(Tier::fast, {{"slab", "plain"}}))) << "the tier's own choice";
  EXPECT_EQ(named(options(Tier::fast, {{"intersector", "watertight"}, {"slab", "padded"}})), "");
}

TEST_F(TiersTest, BadOptionsAreRefusedInEveryTier) {
  EXPECT_THROW(options(Tier::fast, {{"slab", "thick"}}), Refusal);
  EXPECT_THROW(options(Tier::strict, {{"colour", 1.0}}), Refusal);
}

TEST_F(TiersTest, OtherOptionsDoNotMatterToTheTier) {
  traversal_.options.push_back({.name = "registers", .help = "", .min = 0, .max = 255, .integer = true});
  EXPECT_TRUE(is_of_tier(traversal_, Tier::fast, options(Tier::fast, {{"registers", 40.0}})));
}

TEST_F(TiersTest, ATraversalWithoutASlabTestHasTheRest) {
  traversal_.options = knob_options(0);
  EXPECT_TRUE(has_tiers(traversal_));
  EXPECT_EQ(named(options(Tier::fast)), " intersector=moeller-trumbore");
  EXPECT_TRUE(is_of_tier(traversal_, Tier::fast, options(Tier::fast)));
}

TEST_F(TiersTest, ATraversalWithoutKnobsHasNoTiers) {
  const test::FakeDevice device;
  const KindInfo& engine = kind_named(device.kinds(), "embree", "");
  const TraversalInfo& traversal = traversal_named(engine, "intersect", "");
  EXPECT_FALSE(has_tiers(traversal));
  EXPECT_EQ(kernel_options(engine, traversal, Tier::fast, {}, ""), complete_options(engine, traversal, {}, ""));
}

}  // namespace
}  // namespace raywalk
