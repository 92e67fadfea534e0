// Which kernel: everything that its compilation depends on but sources, compiler and architecture.
#pragma once
#include <compare>
#include <string>
#include <string_view>

#include "kernels/features.h"
#include "kernels/frame_request.h"

namespace raywalk::cuda {

/// One of the files kernels/gpu/<name>.cu.
enum class Program { frame, trace, count, fault };
std::string_view name_of(Program program);

struct KernelSpec {
  Program program = Program::frame;
  std::string traversal;  // a type of kernels/accel/traversals.h
  // Types of kernels/knobs.h.
  std::string intersector = "Watertight", slab = "PaddedSlab", spawn = "ErrorBoundOffset", nodes = "FloatNodes";
  u32 features = kAllFeatures;
  Mode mode = Mode::primary;
  u32 block = 128;        // threads
  u32 registers = 0;      // cap a thread; 0: the compiler's choice
  u32 stack_entries = 4;  // of a short stack

  auto operator<=>(const KernelSpec&) const = default;
  /// Readable and unique, such as "frame BvhWhileWhile Watertight features=3 mode=0 block=128 stack_entries=4"; box
  /// test, spawn offset and nodes where they are not the default.
  std::string name() const;
};

}  // namespace raywalk::cuda
