// Which kernels are listed, and that the binary holds their sources.
#include "server/device/cuda/kernel_listing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "server/device/cuda/sources.h"
#include "server/device/cuda/traversal_types.h"

namespace raywalk::cuda {
namespace {

TEST(KernelListing, CoversEveryTraversalOnce) {
  const std::vector<KernelSpec> specs = representative_kernels();
  EXPECT_EQ(std::set<KernelSpec>(specs.begin(), specs.end()).size(), specs.size());
  std::set<std::string> names;
  for (const KernelSpec& spec : specs) names.insert(spec.name());
  EXPECT_EQ(names.size(), specs.size());
  for (const TraversalType& type : traversal_types()) {
    for (const Program program : {Program::frame, Program::trace, Program::count}) {
      EXPECT_TRUE(std::ranges::any_of(
          specs, [&](const KernelSpec& spec) { return spec.traversal == type.type && spec.program == program; }))
          << type.type << ' ' << name_of(program);
    }
  }
}

TEST(KernelListing, SourcesHoldEveryProgramAndWhatItIncludes) {
  std::set<std::string_view> names;
  for (const Source& source : kernel_sources()) EXPECT_TRUE(names.insert(source.name).second) << source.name;
  for (const Program program : {Program::frame, Program::trace, Program::count, Program::fault}) {
    EXPECT_TRUE(names.contains("kernels/gpu/" + std::string(name_of(program)) + ".cu")) << name_of(program);
  }
  constexpr std::string_view kInclude = "#include \"";
  for (const Source& source : kernel_sources()) {
    const std::string_view text = source.text;
    for (size_t at = text.find(kInclude); at != std::string_view::npos; at = text.find(kInclude, at)) {
      at += kInclude.size();
      const std::string_view name = text.substr(at, text.find('"', at) - at);
      EXPECT_TRUE(names.contains(name)) << source.name << " includes " << name;
    }
  }
}

}  // namespace
}  // namespace raywalk::cuda
