// Container, version, extensions and the ranges of images.
#include "server/scene/formats/gltf/precheck.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "kernels/platform.h"
#include "server/scene/scene_builder.h"

namespace raywalk::gltf {
namespace {

using Json = nlohmann::json;

constexpr size_t kMostJsonBytes = 256u << 20;  // the parsed document is up to ten times as large
constexpr u64 kMostBufferBytes = 1ull << 40;   // so that no sum overflows
constexpr int kDeepest = 64;
constexpr size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr u32 kJsonChunk = 0x4e4f534a;

constexpr std::array<std::string_view, 7> kKnownExtensions = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior",    "KHR_materials_transmission",
    "KHR_materials_unlit", "KHR_mesh_quantization",           "KHR_texture_transform"};

u32 u32_at(const std::string& bytes, size_t at) {
  u32 value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// "<file>, line <n>" of the byte `at`.
std::string place_of(std::string_view text, size_t at, const std::string& file) {
  const std::string_view before = text.substr(0, std::min(text.size(), at));
  return at_line(file, 1 + static_cast<u64>(std::count(before.begin(), before.end(), '\n')));
}

/// What reads the document afterwards recurses.
void check_depth(std::string_view text, const std::string& file) {
  int depth = 0;
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      i += c == '\\';  // what follows is no end
      quoted = c != '"';
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepest) {
        throw std::runtime_error(place_of(text, i, file) + ": JSON nested deeper than " + std::to_string(kDeepest) +
                                 " levels");
      }
    } else {
      depth -= c == ']' || c == '}';
      quoted = c == '"';
    }
  }
}

Json parse(std::string_view text, const std::string& file) {
  try {
    return Json::parse(text.begin(), text.end());
  } catch (const Json::parse_error& e) {
    throw std::runtime_error(place_of(text, e.byte, file) + ": not JSON (" + e.what() + ")");
  } catch (const Json::out_of_range& e) {
    // A number beyond all floats, which stands between quotation marks; where it is, the exception does not say.
    const std::string_view says = e.what();
    const size_t begin = says.find('\'') + 1;
    throw std::runtime_error(place_of(text, text.find(says.substr(begin, says.rfind('\'') - begin)), file) + ": " +
                             e.what());
  } catch (const Json::exception& e) {
    throw std::runtime_error(file + ": " + e.what());
  }
}

/// The array `name`, or an empty one.
const Json& array_of(const Json& document, const char* name) {
  static const Json empty = Json::array();
  const auto found = document.find(name);
  return found != document.end() && found->is_array() ? *found : empty;
}

/// An index, offset or length; `otherwise` if it is missing.
u64 number_of(const Json& object, const char* name, u64 otherwise, const std::string& place) {
  if (!object.is_object()) throw std::runtime_error(place + " is no object");
  const auto found = object.find(name);
  if (found == object.end()) return otherwise;
  if (!found->is_number_unsigned()) throw std::runtime_error(place + ": '" + name + "' is not a whole number");
  return found->get<u64>();
}

/// tinygltf takes an image's bytes out of the buffer without looking. Images that overlap without being the same could
/// ask for any number of decodings.
void check_images(const Json& document, const std::string& file) {
  const Json& views = array_of(document, "bufferViews");
  const Json& buffers = array_of(document, "buffers");
  constexpr u64 kNone = ~u64{0};
  std::set<u64> views_of_images, buffers_of_images;
  u64 image_bytes = 0, buffer_bytes = 0;
  size_t number = 0;
  for (const Json& image : array_of(document, "images")) {
    const std::string place = file + ": images/" + std::to_string(number++);
    if (!image.is_object() || !image.contains("bufferView")) continue;
    const u64 index = number_of(image, "bufferView", kNone, place);
    if (index >= views.size()) throw std::runtime_error(place + ": there is no such bufferView");
    const std::string view_place = file + ": bufferViews/" + std::to_string(index);
    const u64 buffer = number_of(views[index], "buffer", kNone, view_place);
    if (buffer >= buffers.size()) throw std::runtime_error(view_place + ": there is no such buffer");
    const u64 size = number_of(buffers[buffer], "byteLength", 0, file + ": buffers/" + std::to_string(buffer));
    const u64 offset = number_of(views[index], "byteOffset", 0, view_place);
    const u64 length = number_of(views[index], "byteLength", 0, view_place);
    const u64 most = std::numeric_limits<int>::max();
    if (length == 0 || length > most || length > size || offset > size - length) {
      throw std::runtime_error(place + ": bufferView " + std::to_string(index) + " lies outside its buffer");
    }
    if (views_of_images.insert(index).second) image_bytes += length;
    if (buffers_of_images.insert(buffer).second) buffer_bytes += std::min(size, kMostBufferBytes);
  }
  if (image_bytes > buffer_bytes) throw std::runtime_error(file + ": images overlap each other in the buffers");
}

}  // namespace

std::string_view json_text(const std::string& bytes, const std::string& file) {
  if (!bytes.starts_with("glTF")) return bytes;
  const auto fail = [&](const std::string& what) { throw std::runtime_error(file + ": " + what); };
  if (bytes.size() < kHeaderBytes + kChunkHeaderBytes) fail("the file ends in its header");
  if (const u32 version = u32_at(bytes, 4); version != 2) {
    fail("glTF container of version " + std::to_string(version) + "; only 2 is known");
  }
  if (u32_at(bytes, 8) > bytes.size()) {
    fail("byte " + std::to_string(bytes.size()) + ": the file ends before its length, " +
         std::to_string(u32_at(bytes, 8)) + " bytes");
  }
  const size_t length = u32_at(bytes, kHeaderBytes), first = kHeaderBytes + kChunkHeaderBytes;
  if (u32_at(bytes, kHeaderBytes + 4) != kJsonChunk || length > bytes.size() - first) {
    fail("byte " + std::to_string(kHeaderBytes) + ": the first chunk is not JSON, or longer than the file");
  }
  return std::string_view(bytes).substr(first, length);
}

void check_json(std::string_view text, const std::string& file) {
  if (text.size() > kMostJsonBytes) throw std::runtime_error(file + ": more than 256 MiB of JSON");
  check_depth(text, file);
  const Json document = parse(text, file);
  if (!document.is_object()) throw std::runtime_error(file + ": not a glTF file: the JSON is no object");
  const auto asset = document.find("asset");
  const bool has_version = asset != document.end() && asset->is_object() && asset->contains("version");
  if (!has_version || !asset->at("version").is_string()) {
    throw std::runtime_error(file + ": not a glTF file: there is no asset version");
  }
  const std::string version = asset->at("version").get<std::string>();
  if (!version.starts_with("2.")) {
    throw std::runtime_error(file + ": glTF version '" + version + "'; only 2.x is known");
  }
  for (const Json& extension : array_of(document, "extensionsRequired")) {
    const std::string name = extension.is_string() ? extension.get<std::string>() : extension.dump();
    if (std::find(kKnownExtensions.begin(), kKnownExtensions.end(), name) == kKnownExtensions.end()) {
      throw std::runtime_error(file + ": the file requires the extension '" + name + "', which is not supported");
    }
  }
  check_images(document, file);
}

}  // namespace raywalk::gltf
