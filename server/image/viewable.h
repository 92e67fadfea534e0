// Frames as 8-bit sRGB pixels that people can look at, whatever the frame holds.
#pragma once
#include <vector>

#include "server/device/device.h"

namespace raywalk {

/// 3 bytes a pixel, rows top down. Depth is grey (near is bright, a miss is black), normals are mapped from [-1, 1],
/// each id has a colour of its own, steps are a heat map scaled to the frame's 99th percentile.
std::vector<u8> viewable(const Frame& frame, Output output);

}  // namespace raywalk
