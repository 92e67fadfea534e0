// What a frame kernel is asked for; shared by host and device.
#pragma once
#include "kernels/shade/camera.h"

namespace raywalk {

enum class Mode : u32 { primary, shadow, whitted };

/// Pixels [x0, x1) x [y0, y1); x0 and y0 are multiples of kBlockSide.
struct Tile {
  u32 x0, y0, x1, y1;
};

/// Side of the pixel blocks whose rays run together.
constexpr u32 kBlockSide = 8;
constexpr u32 kBlockRays = kBlockSide * kBlockSide;

/// Place of lane `i` in its block: Morton order, so that any aligned 2^k lanes are a compact patch.
RW_FN u32 block_x(u32 i) {
  return (i & 1u) | ((i >> 1) & 2u) | ((i >> 2) & 4u);
}
RW_FN u32 block_y(u32 i) {
  return block_x(i >> 1);
}

constexpr u32 kAllLights = ~0u;

struct FrameArgs {
  Camera camera;
  u32 width, height;
  Mode mode;
  u32 depth;   // bounces of secondary rays in Mode::whitted
  u32 lights;  // so many of the scene's shine, the first ones; kAllLights: all
};

/// Frames of one GPU launch, alike but for their cameras. Passed by value, it lies in constant memory.
struct FrameBatch {
  static constexpr u32 kMax = 16;
  FrameArgs alike;
  Camera cameras[kMax];

  RW_FN FrameArgs frame(u32 i) const {
    FrameArgs args = alike;
    args.camera = cameras[i];
    return args;
  }
};

}  // namespace raywalk
