// Listing and loading of catalogue scenes.
#include "server/scene/catalog_files.h"

#include <algorithm>

#include "scenes/generator.h"
#include "server/scene/byte_reader.h"
#include "server/scene/importer.h"
#include "server/scene/manifest.h"
#include "server/scene/sinks.h"
#include "server/scene/split.h"
#include "server/system/sha256.h"

namespace raywalk {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStandInNote = "generated with the study's numbers of triangles and lights; not its geometry";

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
  for (std::span<const u8> bytes = reader.peek_some(kStep); !bytes.empty(); bytes = reader.peek_some(kStep)) {
    hash.add(bytes.data(), bytes.size());
    reader.skip(bytes.size());
  }
  return hash.hex();
}

/// A generated scene stands in for another if there is an original, or the study measured one.
Fidelity generated_fidelity(const Manifest& manifest) {
  return manifest.original || !manifest.paper_json.empty() ? Fidelity::kStandIn : Fidelity::kProcedural;
}

std::string generated_by(const GeneratorSource& generator, u64 triangles) {
  return "generator " + generator.name + ", " + std::to_string(triangles) + " triangles";
}

void dress(Scene& scene, const Appearance& appearance) {
  scene.materials = appearance.materials;
  scene.lights = appearance.lights;
  scene.ambient = appearance.ambient;
  scene.background = appearance.background;
  scene.camera_path = appearance.camera_path(bounds_of(scene));
}

std::vector<Light> chosen_lights(const Scene& scene, const std::vector<u32>& numbers, const fs::path& file) {
  std::vector<Light> lights;
  for (const u32 number : numbers) {
    if (number >= scene.lights.size()) {
      throw std::runtime_error(file.string() + ": has " + std::to_string(scene.lights.size()) +
                               " lights, the manifest asks for number " + std::to_string(number));
    }
    lights.push_back(scene.lights[number]);
  }
  return lights;
}

/// The manifest's look, but for what the file keeps.
void dress_original(Scene& scene, const OriginalSource& original, const fs::path& file) {
  const FromFile& from_file = original.from_file;
  Scene own = std::move(scene);
  scene = {};
  scene.positions = std::move(own.positions);
  scene.normals = std::move(own.normals);
  scene.texcoords = std::move(own.texcoords);
  scene.triangles = std::move(own.triangles);
  scene.content_sha256 = std::move(own.content_sha256);
  scene.cameras = std::move(own.cameras);
  scene.warnings = std::move(own.warnings);
  dress(scene, original.appearance);
  if (from_file.materials) {
    scene.materials = std::move(own.materials);
    scene.textures = std::move(own.textures);
  }
  if (!from_file.lights.empty()) scene.lights = chosen_lights(own, from_file.lights, file);
  if (from_file.ambient) scene.ambient = own.ambient;
  if (from_file.background) scene.background = own.background;
  if (from_file.camera) {
    if (!own.has_camera_path) throw std::runtime_error(file.string() + ": has no camera path");
    scene.camera_path = std::move(own.camera_path);
    scene.camera_path.frames = original.appearance.frames;
  }
}

ImportSettings settings_of(const OriginalSource& original, const fs::path& data_dir, DecodeTexture decode) {
  ImportSettings settings;
  settings.root = data_dir / *original.file.begin();
  settings.decode = std::move(decode);
  settings.cone_slices = original.cone_slices.value_or(settings.cone_slices);
  if (original.sphere) {
    settings.sphere_slices = original.sphere->first;
    settings.sphere_stacks = original.sphere->second;
  }
  return settings;
}

Scene load_original(const OriginalSource& original, const fs::path& data_dir, const fs::path& file,
                    DecodeTexture decode) {
  Scene scene = load_mesh(file, settings_of(original, data_dir, std::move(decode)));
  const bool altered = scene.triangles.size() != original.triangles || content_sha256_of(file) != original.sha256;
  const u64 found_triangles = scene.triangles.size();
  dress_original(scene, original, file);
  if (original.split_to) {
    split_edges(scene, std::max(*original.split_to, found_triangles));
    scene.content_sha256 = geometry_sha256(scene);
  }
  scene.source = original.file.generic_string();
  scene.fidelity = altered ? Fidelity::kDerived : original.fidelity;
  scene.fidelity_note = altered ? "made from another file than the manifest describes" : original.change;
  if (altered) {
    scene.warnings.push_back(file.string() + ": differs from the file that the manifest describes (" +
                             std::to_string(original.triangles) + " triangles, SHA-256 " + original.sha256 + ")");
  }
  return scene;
}

Scene load_generated(const Manifest& manifest, u64 triangles) {
  const Generator* generator = find_generator(manifest.generator->name);
  if (generator == nullptr)
    throw std::runtime_error(manifest.name + ": no generator '" + manifest.generator->name + "'");
  Scene scene;
  SceneSink sink(scene);
  generate(*generator, triangles, sink);
  scene.content_sha256 = geometry_sha256(scene);
  dress(scene, manifest.appearance);
  scene.source = generated_by(*manifest.generator, triangles);
  scene.fidelity = generated_fidelity(manifest);
  if (scene.fidelity == Fidelity::kStandIn) scene.fidelity_note = kStandInNote;
  return scene;
}

SceneInfo info_of(const Manifest& manifest, const fs::path& data_dir) {
  SceneInfo info;
  info.name = manifest.name;
  info.title = manifest.title;
  info.prose = manifest.prose;
  info.lights = static_cast<u32>(manifest.appearance.lights.size());
  info.frames = manifest.appearance.frames;
  info.has_generator = manifest.generator.has_value();
  info.paper_json = manifest.paper_json;
  if (manifest.original) {
    info.credit = manifest.original->credit;
    info.home_url = manifest.original->home_url;
  }
  if (!find_original(manifest, data_dir).empty()) {
    info.triangles = manifest.original->shown_triangles();
    info.lights = static_cast<u32>(manifest.original->light_count());
    info.frames = manifest.original->appearance.frames;
    info.fidelity = manifest.original->fidelity;
    info.fidelity_note = manifest.original->change;
    info.source = manifest.original->file.generic_string();
  } else if (manifest.generator) {
    info.triangles = manifest.generator->triangles;
    info.fidelity = generated_fidelity(manifest);
    if (info.fidelity == Fidelity::kStandIn) info.fidelity_note = kStandInNote;
    info.source = generated_by(*manifest.generator, info.triangles);
  } else {
    info.triangles = manifest.original->shown_triangles();
    info.fidelity = manifest.original->fidelity;
    info.fidelity_note = manifest.original->change;
    info.source = manifest.original->file.generic_string();
    info.available = false;
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
                 std::optional<u64> triangles, DecodeTexture decode) {
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
  const fs::path original = triangles ? fs::path() : find_original(manifest, data_dir);
  if (!original.empty()) {
    scene = load_original(*manifest.original, data_dir, original, std::move(decode));
  } else if (manifest.generator) {
    scene = load_generated(manifest, triangles.value_or(manifest.generator->triangles));
  } else {
    throw std::runtime_error("scene " + manifest.name + ": its data is not at " +
                             (data_dir / manifest.original->file).string());
  }
  scene.name = manifest.name;
  return scene;
}

}  // namespace raywalk
