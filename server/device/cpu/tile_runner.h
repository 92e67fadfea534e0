// Runs work over the tiles of a frame, or over pieces of a ray list, on a fixed number of threads.
#pragma once
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "kernels/frame_request.h"

namespace raywalk {

class TileRunner {
 public:
  /// `threads` threads; 0 means all processors.
  explicit TileRunner(u32 threads) : arena_(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads)) {
    arena_.initialize();
  }
  u32 threads() const { return static_cast<u32>(arena_.max_concurrency()); }

  /// work(Tile) for every tile of a width x height frame.
  template <class Work>
  void over_tiles(u32 width, u32 height, Work work) {
    const u32 across = (width + kTileSide - 1) / kTileSide, down = (height + kTileSide - 1) / kTileSide;
    over_range(u64{across} * down, 1, [&](u64 first, u64 last) {
      for (u64 i = first; i < last; ++i) {
        const u32 x0 = static_cast<u32>(i % across) * kTileSide, y0 = static_cast<u32>(i / across) * kTileSide;
        work(Tile{x0, y0, std::min(x0 + kTileSide, width), std::min(y0 + kTileSide, height)});
      }
    });
  }
  /// work(first, last) for pieces of a list of rays, each a whole number of blocks but for the last.
  template <class Work>
  void over_rays(u64 count, Work work) {
    const u64 pieces = (count + kPieceRays - 1) / kPieceRays;
    over_range(pieces, 1, [&](u64 first, u64 last) { work(first * kPieceRays, std::min(last * kPieceRays, count)); });
  }
  /// Runs `work()` inside the arena, for builders that are parallel themselves.
  template <class Work>
  auto inside(Work work) {
    return arena_.execute(work);
  }

 private:
  static constexpr u32 kTileSide = 4 * kBlockSide;
  static constexpr u64 kPieceRays = 4 * kBlockRays;

  template <class Work>
  void over_range(u64 count, u64 grain, Work work) {
    arena_.execute([&] {
      tbb::parallel_for(tbb::blocked_range<u64>(0, count, grain),
                        [&](const tbb::blocked_range<u64>& r) { work(r.begin(), r.end()); });
    });
  }
  tbb::task_arena arena_;
};

}  // namespace raywalk
