// Picks the format and completes what a bare mesh lacks.
#include "server/scene/importer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

#include "server/scene/formats/formats.h"

namespace raywalk {
namespace {

constexpr std::array kFormats = {&kPly};
constexpr size_t kHeadBytes = 256;

/// Lower case, and that before ".gz" if there is one.
std::string extension_of(std::filesystem::path path) {
  if (path.extension() == ".gz") path = path.stem();
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

std::span<const u8> head_of(ByteReader& reader) {
  for (size_t count = kHeadBytes; count > 0; count /= 2) {
    if (const u8* head = reader.peek(count)) return {head, count};
  }
  return {};
}

const Format& format_of(ByteReader& reader) {
  const std::span<const u8> head = head_of(reader);
  for (const Format* format : kFormats) {
    if (format->begins(head)) return *format;
  }
  const std::string extension = extension_of(reader.path());
  std::string known;
  for (const Format* format : kFormats) {
    if (extension == format->extension) return *format;
    known += std::string(known.empty() ? "" : ", ") + format->name;
  }
  throw std::runtime_error(reader.path().string() + ": not a known mesh format (known: " + known + ")");
}

}  // namespace

Scene load_mesh(const std::filesystem::path& path) {
  ByteReader reader(path);
  Scene scene = format_of(reader).load(reader);
  scene.name = path.stem().string();
  scene.source = path.filename().string();
  scene.content_sha256 = geometry_sha256(scene);
  add_default_lighting(scene);
  return scene;
}

void add_default_lighting(Scene& scene) {
  if (!scene.lights.empty()) return;
  scene.camera_path = orbit_around(bounds_of(scene));
  const OrbitPath& orbit = std::get<OrbitPath>(scene.camera_path.shape);
  // Over the left shoulder of the first frame.
  scene.lights.push_back({orbit.centre + orbit.radius * Vec3{-0.7f, 1.3f, 1.2f}, {1.0f, 1.0f, 1.0f}});
  scene.ambient = {0.12f, 0.12f, 0.12f};
  scene.background = {0.05f, 0.06f, 0.08f};
}

}  // namespace raywalk
