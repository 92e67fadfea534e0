// Where the fake libraries lie: beside the test program.
#pragma once
#include <filesystem>
#include <string>

namespace raywalk::test {

/// `name` is fake_cuda, fake_cuda_incomplete, which lacks cuLaunchKernel, fake_nvml or fake_nvrtc.
inline std::string fake_driver(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / ("lib" + name + ".so");
}

}  // namespace raywalk::test
