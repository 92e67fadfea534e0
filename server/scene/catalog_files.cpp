// Listing and loading of catalogue scenes.
#include "server/scene/catalog_files.h"

#include <algorithm>

#include "scenes/generator.h"
#include "server/scene/byte_reader.h"
#include "server/scene/importer.h"
#include "server/scene/manifest.h"
#include "server/scene/sinks.h"
#include "server/system/sha256.h"

namespace raywalk {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> manifest_files(const fs::path& scenes_dir) {
  std::error_code error;
  if (!fs::is_directory(scenes_dir, error))
    throw std::runtime_error(scenes_dir.string() + ": no such folder of scenes");
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(scenes_dir)) {
    const fs::path file = entry.path() / "scene.json";
    if (fs::is_regular_file(file, error)) files.push_back(file);
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string name_of(const fs::path& manifest_file) {
  return manifest_file.parent_path().filename().string();
}

/// The original's file, stored as it is or with or without gzip; empty if it is not there.
fs::path find_original(const Manifest& manifest, const fs::path& data_dir) {
  if (!manifest.original) return {};
  const fs::path file = data_dir / manifest.original->file;
  const fs::path other =
      file.extension() == ".gz" ? fs::path(file).replace_extension() : fs::path(file.string() + ".gz");
  std::error_code error;
  for (const fs::path& candidate : {file, other}) {
    if (fs::is_regular_file(candidate, error)) return candidate;
  }
  return {};
}

std::string content_sha256_of(const fs::path& file) {
  ByteReader reader(file);
  Sha256 hash;
  constexpr size_t kStep = 1 << 16;
  for (size_t step = kStep; step > 0;) {
    const u8* bytes = reader.peek(step);
    if (bytes == nullptr) {
      step /= 2;
      continue;
    }
    hash.add(bytes, step);
    reader.skip(step);
  }
  return hash.hex();
}

std::string generated_by(const GeneratorSource& generator, u64 triangles) {
  return "generator " + generator.name + ", " + std::to_string(triangles) + " triangles";
}

void load_original(Scene& scene, const OriginalSource& original, const fs::path& file) {
  Scene mesh = load_mesh(file);
  scene.positions = std::move(mesh.positions);
  scene.normals = std::move(mesh.normals);
  scene.triangles = std::move(mesh.triangles);
  scene.warnings = std::move(mesh.warnings);
  scene.source = original.file.generic_string() + " (" + original.credit + ")";
  scene.fidelity = original.fidelity;
  const bool altered = scene.triangles.size() != original.triangles || content_sha256_of(file) != original.sha256;
  if (altered) {
    scene.fidelity = Fidelity::kDerived;
    scene.warnings.push_back(file.string() + ": differs from the file that the manifest describes (" +
                             std::to_string(original.triangles) + " triangles, SHA-256 " + original.sha256 + ")");
  }
}

void load_generated(Scene& scene, const Manifest& manifest, u64 triangles) {
  const Generator* generator = find_generator(manifest.generator->name);
  if (generator == nullptr)
    throw std::runtime_error(manifest.name + ": no generator '" + manifest.generator->name + "'");
  SceneSink sink(scene);
  generate(*generator, triangles, sink);
  scene.source = generated_by(*manifest.generator, triangles);
  scene.fidelity = manifest.original ? Fidelity::kStandIn : Fidelity::kProcedural;
}

SceneInfo info_of(const Manifest& manifest, const fs::path& data_dir) {
  SceneInfo info;
  info.name = manifest.name;
  info.title = manifest.title;
  info.prose = manifest.prose;
  info.lights = static_cast<u32>(manifest.lights.size());
  info.frames = manifest.frames;
  info.has_generator = manifest.generator.has_value();
  info.paper_json = manifest.paper_json;
  if (manifest.original) {
    info.credit = manifest.original->credit;
    info.home_url = manifest.original->home_url;
  }
  if (!find_original(manifest, data_dir).empty()) {
    info.triangles = manifest.original->triangles;
    info.fidelity = manifest.original->fidelity;
    info.source = manifest.original->file.generic_string();
  } else if (manifest.generator) {
    info.triangles = manifest.generator->triangles;
    info.fidelity = manifest.original ? Fidelity::kStandIn : Fidelity::kProcedural;
    info.source = generated_by(*manifest.generator, info.triangles);
  }
  return info;
}

}  // namespace

UnknownScene::UnknownScene(std::string_view name, std::vector<std::string> known)
    : std::runtime_error([&] {
        std::string text = "no scene '" + std::string(name) + "'; there are:";
        for (const std::string& one : known) text += " " + one;
        return text;
      }()),
      known_(std::move(known)) {}

std::vector<SceneInfo> list_scenes(const fs::path& scenes_dir, const fs::path& data_dir) {
  std::vector<SceneInfo> scenes;
  for (const fs::path& file : manifest_files(scenes_dir)) scenes.push_back(info_of(read_manifest(file), data_dir));
  return scenes;
}

Scene load_scene(std::string_view name, const fs::path& scenes_dir, const fs::path& data_dir,
                 std::optional<u64> triangles) {
  const std::vector<fs::path> files = manifest_files(scenes_dir);
  const auto file = std::find_if(files.begin(), files.end(), [&](const fs::path& f) { return name_of(f) == name; });
  if (file == files.end()) {
    std::vector<std::string> known;
    for (const fs::path& f : files) known.push_back(name_of(f));
    throw UnknownScene(name, std::move(known));
  }
  const Manifest manifest = read_manifest(*file);
  if (triangles && !manifest.generator) {
    throw std::invalid_argument("scene " + manifest.name + " is not generated: its number of triangles is fixed");
  }

  Scene scene;
  scene.name = manifest.name;
  const fs::path original = triangles ? fs::path() : find_original(manifest, data_dir);
  if (!original.empty()) {
    load_original(scene, *manifest.original, original);
  } else if (manifest.generator) {
    load_generated(scene, manifest, triangles.value_or(manifest.generator->triangles));
  } else {
    throw std::runtime_error("scene " + manifest.name + ": its data is not at " +
                             (data_dir / manifest.original->file).string());
  }
  scene.materials = manifest.materials;
  scene.lights = manifest.lights;
  scene.ambient = manifest.ambient;
  scene.background = manifest.background;
  scene.camera_path = manifest.camera_path(bounds_of(scene));
  scene.content_sha256 = geometry_sha256(scene);
  return scene;
}

}  // namespace raywalk
