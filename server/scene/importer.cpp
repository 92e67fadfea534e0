// Picks the format and completes what a bare mesh lacks.
#include "server/scene/importer.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "server/scene/byte_reader.h"
#include "server/scene/formats/formats.h"

namespace raywalk {
namespace {

constexpr size_t kHeadBytes = 1024;

/// Lower case, and that before ".gz" if there is one.
std::string extension_of(std::filesystem::path path) {
  if (path.extension() == ".gz") path = path.stem();
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

const Format& format_of(const std::filesystem::path& path, const std::string& given_extension) {
  ByteReader reader(path);
  const std::span<const u8> head = reader.peek_some(kHeadBytes);
  for (const Format* format : formats()) {
    if (format->begins(head)) return *format;
  }
  const std::string extension = given_extension.empty() ? extension_of(path) : given_extension;
  std::string known;
  for (const Format* format : formats()) {
    const auto& its = format->extensions;
    if (!extension.empty() && std::find(its.begin(), its.end(), extension) != its.end()) return *format;
    known += std::string(known.empty() ? "" : ", ") + format->name;
  }
  throw std::runtime_error(path.string() + ": not a known scene format (known: " + known + ")");
}

}  // namespace

Scene load_mesh(const std::filesystem::path& path, ImportSettings settings) {
  const Format& format = format_of(path, settings.extension);
  ImportFiles files(path, std::move(settings));
  Scene scene = format.load(files);
  scene.name = path.stem().string();
  scene.source = path.filename().string();
  scene.content_sha256 = geometry_sha256(scene);
  add_default_lighting(scene);
  return scene;
}

void add_default_lighting(Scene& scene) {
  const CameraPath around = orbit_around(bounds_of(scene));
  const OrbitPath& orbit = std::get<OrbitPath>(around.shape);
  if (!scene.has_camera_path) scene.camera_path = around;
  if (!scene.lights.empty()) return;
  // Over the left shoulder of the first frame.
  scene.lights.push_back({orbit.centre + orbit.radius * Vec3{-0.7f, 1.3f, 1.2f}, {1.0f, 1.0f, 1.0f}});
  scene.ambient = {0.12f, 0.12f, 0.12f};
  scene.background = {0.05f, 0.06f, 0.08f};
}

}  // namespace raywalk
