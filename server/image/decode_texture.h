// Image files, as they lie in memory, into textures.
#pragma once
#include <span>

#include "server/scene/scene.h"

namespace raywalk {

/// The first image of a PNG, JPEG, PNM (PPM, PGM, PBM, PFM), BMP, OpenEXR, Radiance HDR or TGA file, told by its
/// content, of any number of channels and any depth: grey becomes RGB, alpha is dropped, integers are taken as sRGB,
/// floats as linear. The texture has no name yet.
/// Throws std::runtime_error with the reason: another format, broken, more than 16384 texels a side, or so many that
/// the file cannot hold them.
Texture decode_texture(std::span<const u8> bytes);

}  // namespace raywalk
