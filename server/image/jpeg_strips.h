// Strips of an image, each encoded as a JPEG of its own, as one JPEG: so that several threads can encode it.
#pragma once
#include <string>
#include <vector>

#include "kernels/platform.h"

namespace raywalk {

/// Rows of every strip but the last: whole rows of blocks whatever the chroma subsampling.
constexpr u32 kJpegStripRows = 64;

/// Strips, top down, of one width, baseline coded with the same tables. They become the restart intervals (ITU-T T.81,
/// E.1.4) of an image of `height` rows. Throws std::runtime_error for what is no such JPEG.
std::string join_jpeg_strips(const std::vector<std::string>& strips, u32 height);

}  // namespace raywalk
