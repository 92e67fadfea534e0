// Kernels with each row of the lists of knobs, and for structures of each form. Compiling is skipped without NVRTC.
#include <gtest/gtest.h>

#include "server/device/cuda/compiler.h"
#include "server/device/cuda/kernel_options.h"
#include "server/device/cuda/nvrtc_api.h"
#include "server/device/knobs.h"

namespace raywalk::cuda {
namespace {

KernelSpec ray_kernel(const OptionValues& options, const StructureForm& form = {}) {
  return kernel_spec(traversal_type("bvh", "while-while"), options, Program::trace, Mode::primary, 0, form);
}

TEST(KnobKernels, AllCompile) {
  const Found<NvrtcApi> nvrtc = open_nvrtc();
  if (!nvrtc) GTEST_SKIP() << nvrtc.why_not;
  const Compiler compiler(nvrtc.value, "sm_90", {});
  std::vector<KernelSpec> specs;
  for (u32 i = 1; i < intersector_rows().size(); ++i) {
    const bool transforms = intersector_rows()[i].name == "baldwin-weber";
    const StructureForm form{transforms ? TriangleRecords::transforms : TriangleRecords::corners};
    specs.push_back(ray_kernel({{"intersector", i}}, form));
  }
  for (u32 i = 1; i < slab_rows().size(); ++i) specs.push_back(ray_kernel({{"slab", i}}));
  for (u32 i = 1; i < node_rows().size(); ++i) specs.push_back(ray_kernel({}, {TriangleRecords::corners, i}));
  for (const KernelSpec& spec : specs) EXPECT_EQ(compiler.compile(spec).entries.size(), 3u) << spec.name();
}

TEST(KnobKernels, FollowTheFormOfTheStructure) {
  EXPECT_EQ(ray_kernel({}).nodes, "FloatNodes");
  EXPECT_EQ(ray_kernel({}, {TriangleRecords::corners, 2}).nodes, "ByteNodes");
  EXPECT_NE(ray_kernel({}, {TriangleRecords::corners, 2}).name(), ray_kernel({}).name());
  EXPECT_THROW(ray_kernel({}, {TriangleRecords::transforms}), std::invalid_argument);
  EXPECT_THROW(ray_kernel({{"intersector", 4}}), std::invalid_argument);
  EXPECT_THROW(ray_kernel({{"slab", 1}}, {TriangleRecords::corners, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace raywalk::cuda
