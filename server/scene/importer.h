// The one door for scene files: picks the format by content, then by extension.
#pragma once
#include <filesystem>

#include "server/scene/import_files.h"

namespace raywalk {

/// Reads a scene file (gzip or plain). The result is renderable: what the file does not say (material, light, ambient
/// light, camera path) has defaults that fit its bounds.
/// Throws std::runtime_error naming the file, and the line (text) or byte (binary), if it cannot be read.
Scene load_mesh(const std::filesystem::path& path, ImportSettings settings = {});

/// Adds an orbit where the scene has no camera path; a light, ambient light and background where it has no light.
void add_default_lighting(Scene& scene);

}  // namespace raywalk
