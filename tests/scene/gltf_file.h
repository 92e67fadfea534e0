// Small glTF files, put together by tests.
#pragma once
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "kernels/platform.h"
#include "tests/support/folder.h"

namespace raywalk::test {

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// One buffer with views and accessors; all else is JSON as it is given.
class GltfFile {
 public:
  /// A member of the document.
  void set(const std::string& name, const std::string& json) { members_[name] = json; }

  /// Index of a new bufferView with these bytes.
  int add_view(const std::string& bytes, int stride = 0) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    views_.push_back(R"({"buffer": 0, "byteOffset": )" + std::to_string(buffer_.size()) + R"(, "byteLength": )" +
                     std::to_string(bytes.size()) + (stride > 0 ? R"(, "byteStride": )" + std::to_string(stride) : "") +
                     "}");
    buffer_ += bytes;
    return static_cast<int>(views_.size() - 1);
  }
  void add_accessor(const std::string& json) { accessors_.push_back(json); }
  /// A view and its accessor; `more` are further members of it, each after a comma.
  void add(const std::string& bytes, int component_type, size_t count, const char* type, const std::string& more = "",
           int stride = 0) {
    add_accessor(R"({"bufferView": )" + std::to_string(add_view(bytes, stride)) + R"(, "componentType": )" +
                 std::to_string(component_type) + R"(, "count": )" + std::to_string(count) + R"(, "type": ")" + type +
                 "\"" + more + "}");
  }
  void add_floats(const std::vector<float>& values, const char* type) {
    const size_t components = static_cast<size_t>(type[3] - '0');
    add(bytes_of(values), 5126, values.size() / components, type);
  }

  /// scene.gltf with its buffer in the file `name`, under which `uri` finds it.
  std::filesystem::path write_gltf(const Folder& folder, const std::string& name = "scene.bin",
                                   const std::string& uri = "scene.bin") const {
    folder.write(name, buffer_);
    return folder.write("scene.gltf", json(R"("uri": ")" + uri + R"(", )"));
  }
  /// scene.glb with everything in it.
  std::filesystem::path write_glb(const Folder& folder) const {
    std::string text = json(""), buffer = buffer_;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    buffer.resize((buffer.size() + 3) / 4 * 4);
    const u32 total = static_cast<u32>(12 + 8 + text.size() + 8 + buffer.size());
    return folder.write("scene.glb", "glTF" + words({2, total, static_cast<u32>(text.size()), 0x4e4f534a}) + text +
                                         words({static_cast<u32>(buffer.size()), 0x004e4942}) + buffer);
  }

 private:
  static std::string words(const std::vector<u32>& values) { return bytes_of(values); }
  static std::string list(const std::vector<std::string>& values) {
    std::string text;
    for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
    return "[" + text + "]";
  }
  std::string json(const std::string& uri) const {
    std::string text = R"({"asset": {"version": "2.0"}, "buffers": [{)" + uri + R"("byteLength": )" +
                       std::to_string(buffer_.size()) + R"(}], "bufferViews": )" + list(views_) + R"(, "accessors": )" +
                       list(accessors_);
    for (const auto& [name, value] : members_) text += ", \"" + name + "\": " + value;
    return text + "}";
  }

  std::map<std::string, std::string> members_;
  std::vector<std::string> views_, accessors_;
  std::string buffer_;
};

}  // namespace raywalk::test
