// Host only: the kernels as the CPU runs them, one row a traversal.
#pragma once
#include <string_view>
#include <vector>

#include "kernels/counter.h"
#include "kernels/frame_request.h"
#include "kernels/knobs.h"
#include "kernels/ray.h"
#include "kernels/scene_view.h"

namespace raywalk {

/// Numbers of rows of the lists in kernels/knobs.h.
struct Knobs {
  u32 intersector = 0, slab = 0, spawn = 0;
  u32 stack_entries = kStackEntries;  // 1 to kMaxStackEntries

  bool operator==(const Knobs&) const = default;
};

/// What rays are traced through. `structure` is the start of a blob of the traversal's kind, built over `scene`; an
/// engine that is not of the kernels passes a handle of its own.
struct TraceTarget {
  SceneView scene;
  const void* structure;
  Knobs knobs;
};

/// One traversal of the CPU, thread-safe.
struct CpuTraversal {
  std::string_view kind, name, help;
  u32 knobs;  // those that it has of kKnobSlab and kKnobStack
  void (*closest)(const TraceTarget& target, const Ray* rays, u64 count, Hit* hits);
  void (*occluded)(const TraceTarget& target, const Ray* rays, u64 count, u8* occluded);
  /// Linear colours of a tile into the frame's `pixels` (width * height, rows top down).
  void (*frame)(const TraceTarget& target, const FrameArgs& args, Tile tile, Vec3* pixels);
  /// The same work compiled with counters: all rays of the tile's pixels.
  Counts (*count_frame)(const TraceTarget& target, const FrameArgs& args, Tile tile);
  /// Counts of each single ray (closest hit).
  void (*count_rays)(const TraceTarget& target, const Ray* rays, u64 count, Counts* counts);
};

/// In the order of RW_TRAVERSALS.
const std::vector<CpuTraversal>& cpu_traversals();

}  // namespace raywalk
