// Scene formats for fuzzing: one by the name of its folder of seeds, and one file of it loaded within small limits.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "server/scene/formats/formats.h"

namespace raywalk::fuzz {

struct NamedFormat {
  std::string name;  // of the source file of the format, and of its folders of seeds
  const Format* format;
};

/// All of them, in the order of their names.
std::span<const NamedFormat> named_formats();

/// The one of that name. Throws std::invalid_argument if there is none.
const Format& format_named(const std::string& name);

/// Loads the bytes as a scene file of the format, through a file in a folder of this process's own, and packs the
/// scene. A std::runtime_error of the loader is what bad files deserve and goes no further; every other exception is
/// let through.
void try_load(const Format& format, std::span<const u8> bytes);

}  // namespace raywalk::fuzz
