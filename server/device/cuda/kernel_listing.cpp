// Compiles many kernels on all processors.
#include "server/device/cuda/kernel_listing.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "server/device/cuda/kernel_options.h"
#include "server/device/cuda/nvrtc_api.h"
#include "server/device/cuda/traversal_types.h"

namespace raywalk::cuda {
namespace {

void check_architectures(const NvrtcApi& nvrtc, const std::vector<std::string>& wanted) {
  const std::vector<std::string> known = nvrtc.architectures();
  for (const std::string& name : wanted) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw UnknownArchitecture("NVRTC " + nvrtc.version() + " does not know the architecture '" + name + "'; it knows " +
                              joined(known) + ".");
  }
}

}  // namespace

std::vector<KernelSpec> representative_kernels() {
  std::vector<KernelSpec> specs;
  for (const TraversalType& type : traversal_types()) {
    for (const Mode mode : {Mode::primary, Mode::shadow, Mode::whitted}) {
      for (const u32 features : {0u, kAllFeatures & ~kFeatureTextures}) {
        specs.push_back(kernel_spec(type, {}, Program::frame, mode, features));
      }
    }
    specs.push_back(kernel_spec(type, {}, Program::frame, Mode::whitted, kAllFeatures));
    specs.push_back(kernel_spec(type, {}, Program::trace, Mode::primary, 0));
    if (type.type == "BvhWhileWhile")
      specs.push_back(kernel_spec(type, {{"intersector", 1}}, Program::trace, Mode::primary, 0));
    specs.push_back(kernel_spec(type, {}, Program::count, Mode::whitted, kAllFeatures));
  }
  return specs;
}

std::vector<ListedKernel> list_kernels(const std::shared_ptr<const NvrtcApi>& nvrtc,
                                       const std::vector<std::string>& architectures,
                                       const std::filesystem::path& cache_dir) {
  check_architectures(*nvrtc, architectures);
  const std::vector<KernelSpec> specs = representative_kernels();
  std::vector<std::vector<EntryReport>> reports(architectures.size() * specs.size());
  std::vector<std::unique_ptr<const Compiler>> compilers;  // a cache that cannot be written says so once each
  for (const std::string& name : architectures)
    compilers.push_back(std::make_unique<const Compiler>(nvrtc, name, cache_dir));
  tbb::parallel_for(size_t{0}, reports.size(), [&](size_t i) {
    reports[i] = compilers[i / specs.size()]->compile(specs[i % specs.size()]).entries;
  });

  std::vector<ListedKernel> rows;
  for (size_t i = 0; i < reports.size(); ++i) {
    for (const EntryReport& report : reports[i]) {
      rows.push_back({architectures[i / specs.size()], specs[i % specs.size()], report});
    }
  }
  return rows;
}

}  // namespace raywalk::cuda
