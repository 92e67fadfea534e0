// The mode of the program that compiles kernels and needs no device.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace raywalk {

/// Prints what the compiler says of all kernels as one JSON document; what `cache_dir` has is not compiled again. The
/// exit code: 0, 1 where a kernel does not compile, 2 for an unknown architecture, 3 without NVRTC; what is wrong goes
/// to stderr.
int compile_kernels(const std::vector<std::string>& architectures, const std::filesystem::path& cache_dir = {});

}  // namespace raywalk
