// Numbers out of the buffers of a glTF file, with every range checked.
#pragma once
#include <string>
#include <vector>

#include "server/scene/formats/gltf/document.h"

namespace raywalk::gltf {

/// How many values the accessor `index` has. Throws std::runtime_error about `part` for a wrong index.
u64 value_count(const Document& document, int index, const std::string& part);

/// All values of an accessor of any component type, `components` floats each; normalised integers become fractions.
/// Throws std::runtime_error about `part` if the accessor is of another type, lies outside its buffer, or has a value
/// that is not finite.
std::vector<float> read_values(const Document& document, int index, u32 components, const std::string& part);

/// The same for indices below `limit`.
std::vector<u32> read_indices(const Document& document, int index, u64 limit, const std::string& part);

}  // namespace raywalk::gltf
