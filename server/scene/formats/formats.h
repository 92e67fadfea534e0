// The table of scene formats. A format is one file <format>.cpp here, with its parts in a folder of that name.
#pragma once
#include <array>
#include <span>
#include <string_view>

#include "server/scene/import_files.h"

namespace raywalk {

struct Format {
  const char* name;
  std::array<std::string_view, 3> extensions;  // lower case, without ".gz"; empty ones are none
  /// Whether the (uncompressed) beginning of a file, at most 1024 bytes, is this format beyond doubt.
  bool (*begins)(std::span<const u8> head);
  /// Fills geometry and warnings, and what the format has of materials, textures, lights, cameras, a camera path,
  /// ambient light and background. Throws std::runtime_error naming file and line (byte in binary files).
  Scene (*load)(ImportFiles& files);
};

/// All formats, by name: every <format>.cpp here defines `extern const Format k_<format>_format`.
std::span<const Format* const> formats();

}  // namespace raywalk
