// A glTF file with its buffers and the bytes of its images, checked as far as tinygltf relies on it.
#pragma once
#include <span>

#include "server/scene/formats/gltf/tinygltf.h"
#include "server/scene/import_files.h"

namespace raywalk::gltf {

struct Document {
  std::string file;  // for messages
  tinygltf::Model model;

  /// "<file>: <part>", with a part such as "meshes/3/primitives/0".
  std::string at(const std::string& part) const { return file + ": " + part; }
  /// Throws std::runtime_error "<file>: <part>: <what>".
  [[noreturn]] void fail(const std::string& part, const std::string& what) const;
  /// The element `index` of one of the model's arrays, `name` in messages about `part`.
  template <class T>
  const T& element(const std::vector<T>& elements, int index, const char* name, const std::string& part) const {
    if (index < 0 || static_cast<size_t>(index) >= elements.size()) {
      fail(part, std::string(name) + " " + std::to_string(index) + " of " + std::to_string(elements.size()));
    }
    return elements[static_cast<size_t>(index)];
  }
  /// What an image holds; nothing if it has a URI that has not been followed.
  std::span<const u8> bytes_of(const tinygltf::Image& image) const;
};

/// Reads .gltf or .glb.
/// Throws std::runtime_error with the file and the reason, among them required extensions that are not known and files
/// outside the root.
Document open_document(ImportFiles& files);

}  // namespace raywalk::gltf
