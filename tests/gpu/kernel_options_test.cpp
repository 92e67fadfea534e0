// What options of a traversal's kernel mean for the compiler, and that they are kept in range.
#include "server/device/cuda/kernel_options.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace raywalk::cuda {
namespace {

std::vector<std::string> names_of(const TraversalType& type) {
  std::vector<std::string> names;
  for (const Option& option : kernel_options(type)) names.emplace_back(option.name);
  return names;
}

TEST(KernelOptions, EachTraversalHasThoseThatMeanSomethingToIt) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of(traversal_type("bvh", "while-while")),
            (Names{"registers", "block", "intersector", "slab", "spawn"}));
  EXPECT_EQ(names_of(traversal_type("bvh", "packet")), (Names{"registers", "block", "intersector", "slab", "spawn"}));
  EXPECT_EQ(names_of(traversal_type("grid", "dda")), (Names{"registers", "block", "intersector", "spawn"}));
  EXPECT_EQ(names_of(traversal_type("kdtree", "short-stack-2")),
            (Names{"registers", "block", "intersector", "stack_entries", "spawn"}));
  EXPECT_THROW(traversal_type("bvh", "dda"), std::invalid_argument);
}

TEST(KernelOptions, DefaultsAreAKernelThatCanRun) {
  for (const TraversalType& type : traversal_types()) {
    const KernelSpec spec = kernel_spec(type, {}, Program::frame, Mode::whitted, kAllFeatures);
    EXPECT_EQ(spec.traversal, type.type);
    EXPECT_EQ(spec.block % 32, 0u) << type.type;
    EXPECT_EQ(spec.block % type.group, 0u) << type.type;
    EXPECT_EQ(spec.features, kAllFeatures);
    EXPECT_EQ(spec.stack_entries, 4u);
  }
}

TEST(KernelOptions, ValuesReachTheKernel) {
  const TraversalType& type = traversal_type("kdtree", "short-stack-3");
  const OptionValues given{{"registers", 48}, {"block", 256}, {"stack_entries", 9}, {"intersector", 0}};
  const KernelSpec spec = kernel_spec(type, given, Program::trace, Mode::shadow, kAllFeatures);
  EXPECT_EQ(spec.registers, 48u);
  EXPECT_EQ(spec.block, 256u);
  EXPECT_EQ(spec.stack_entries, 9u);
  EXPECT_EQ(spec.intersector, "Watertight");
  EXPECT_EQ(kernel_spec(type, {{"intersector", 1}}, Program::trace, Mode::primary, 0).intersector, "MoellerTrumbore");
}

TEST(KernelOptions, ValuesOutOfRangeAreRefused) {
  const TraversalType& single = traversal_type("bvh", "while-while");
  const auto refused = [&](const TraversalType& type, const OptionValues& given) {
    EXPECT_THROW(kernel_spec(type, given, Program::frame, Mode::primary, 0), std::invalid_argument);
  };
  refused(single, {{"registers", 256}});
  refused(single, {{"registers", 23}});
  refused(single, {{"registers", 1}});
  refused(single, {{"registers", 40.5}});
  refused(single, {{"block", 0}});
  refused(single, {{"block", 100}});
  refused(single, {{"block", 544}});
  refused(single, {{"stack_entries", 4}});
  refused(single, {{"intersector", 99}});
  refused(traversal_type("bvh", "packet"), {{"block", 16}});
  refused(traversal_type("kdtree", "short-stack-2"), {{"stack_entries", 17}});
}

TEST(KernelOptions, ACapOfRegistersIsOneThatTheAssemblerKeeps) {
  const TraversalType& type = traversal_type("bvh", "while-while");
  const auto registers = [&](u32 cap) {
    return kernel_spec(type, {{"registers", cap}}, Program::frame, Mode::primary, 0).registers;
  };
  for (const u32 cap : {0u, 24u, 255u}) EXPECT_EQ(registers(cap), cap);
  try {
    registers(23);
    FAIL() << "no exception";
  } catch (const std::invalid_argument& e) {
    EXPECT_STREQ(e.what(),
                 "bvh/while-while option registers: 23 is neither 0 nor 24 to 255, which is what the "
                 "assembler can do");
  }
}

TEST(KernelOptions, FeaturesThatCannotMatterShareAKernel) {
  const TraversalType& type = traversal_type("grid", "dda");
  const auto spec = [&](Program program, Mode mode, u32 features) {
    return kernel_spec(type, {}, program, mode, features);
  };
  const u32 mirror = kFeatureSpecular | kFeatureReflection, plain = kFeatureSpecular;
  EXPECT_EQ(spec(Program::frame, Mode::shadow, mirror), spec(Program::frame, Mode::shadow, plain));
  EXPECT_NE(spec(Program::frame, Mode::whitted, mirror), spec(Program::frame, Mode::whitted, plain));
  EXPECT_NE(spec(Program::frame, Mode::primary, mirror), spec(Program::frame, Mode::shadow, mirror));
  EXPECT_EQ(spec(Program::trace, Mode::primary, 0), spec(Program::trace, Mode::whitted, kAllFeatures));
}

}  // namespace
}  // namespace raywalk::cuda
