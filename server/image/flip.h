// The difference that one sees when two pictures alternate.
#pragma once
#include <vector>

#include "server/device/device.h"

namespace raywalk {

/// LDR-FLIP after Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom and Fairchild (HPG 2020): an error in 0..1 for
/// each pixel, rows top down, on a monitor 0.7 m and 3840 pixels wide seen from 0.7 m (67 pixels a degree). Colours are
/// linear sRGB, clipped to 0..1, NaN as 0. Beyond the borders the outermost pixels go on. Both frames have three
/// channels and the same size, at least one pixel.
std::vector<float> flip_errors(const Frame& reference, const Frame& image);

}  // namespace raywalk
