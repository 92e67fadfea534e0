// Image files in memory, and float32 as it is.
#pragma once
#include <string>

#include "server/device/device.h"

namespace raywalk {

enum class ImageFormat { jpeg, png, exr, raw };

/// JPEG (quality 90) and PNG show `viewable` colours; EXR (half for colour and normals, float for the rest) and raw
/// (float32, little endian, rows top down) hold the frame's values. Throws std::runtime_error.
std::string encode(const Frame& frame, Output output, ImageFormat format);

/// The image library and its version.
std::string image_library_version();

}  // namespace raywalk
