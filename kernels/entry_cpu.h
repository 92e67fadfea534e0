// Host only: the kernels as the CPU runs them, one row a traversal.
#pragma once
#include <string_view>
#include <vector>

#include "kernels/counter.h"
#include "kernels/frame_request.h"
#include "kernels/ray.h"
#include "kernels/scene_view.h"

namespace raywalk {

/// One traversal of the CPU, thread-safe. `structure` is the start of a blob of that kind, built over `scene`; an
/// engine that is not of the kernels passes a handle of its own.
struct CpuTraversal {
  std::string_view kind, name, help;
  void (*closest)(SceneView scene, const void* structure, const Ray* rays, u64 count, Hit* hits);
  void (*occluded)(SceneView scene, const void* structure, const Ray* rays, u64 count, u8* occluded);
  /// Linear colours of a tile into the frame's `pixels` (width * height, rows top down).
  void (*frame)(SceneView scene, const void* structure, const FrameArgs& args, Tile tile, Vec3* pixels);
  /// The same work compiled with counters: all rays of the tile's pixels.
  Counts (*count_frame)(SceneView scene, const void* structure, const FrameArgs& args, Tile tile);
  /// Counts of each single ray (closest hit).
  void (*count_rays)(SceneView scene, const void* structure, const Ray* rays, u64 count, Counts* counts);
};

/// In the order of RW_TRAVERSALS.
const std::vector<CpuTraversal>& cpu_traversals();

}  // namespace raywalk
