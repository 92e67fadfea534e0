// The kernel files inside the binary.
#pragma once
#include <span>

namespace raywalk::cuda {

/// A file by its name from the root of the source tree, such as "kernels/vec.h", which is how it is included.
struct Source {
  const char* name;
  const char* text;
};

/// kernels/gpu/*.cu and every header that they reach, in order of their names.
std::span<const Source> kernel_sources();

}  // namespace raywalk::cuda
