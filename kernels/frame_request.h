// What a frame kernel is asked for; shared by host and device.
#pragma once
#include "kernels/shade/camera.h"

namespace raywalk {

enum class Mode : u32 { primary, shadow, whitted };

struct FrameArgs {
  Camera camera;
  u32 width, height;
  Mode mode;
  u32 depth;  // bounces of secondary rays in Mode::whitted
};

}  // namespace raywalk
