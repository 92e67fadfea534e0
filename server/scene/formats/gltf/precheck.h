// What is checked in a glTF file before tinygltf sees it.
#pragma once
#include <string>
#include <string_view>

namespace raywalk::gltf {

/// The JSON text of a .gltf or .glb file. Throws std::runtime_error for a container that is cut short or not version 2.
std::string_view json_text(const std::string& bytes, const std::string& file);

/// Throws std::runtime_error with file and line for what is no JSON, nested too deep, or has a number beyond all
/// floats; with the file for another version than 2, required extensions that are not known, and images outside of
/// their buffers.
void check_json(std::string_view text, const std::string& file);

}  // namespace raywalk::gltf
