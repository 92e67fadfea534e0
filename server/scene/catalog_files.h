// The catalogue: scenes/<name>/scene.json, with original data where it is present and generated stand-ins elsewhere.
#pragma once
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "server/scene/import_files.h"

namespace raywalk {

/// What is known of a scene without loading its geometry.
struct SceneInfo {
  std::string name;
  std::string title;
  std::string prose;
  u64 triangles = 0;  // that load_scene would give now
  u32 lights = 0;
  Fidelity fidelity = Fidelity::kProcedural;
  std::string fidelity_note;  // how it differs from the study's scene; empty if it does not, or there is none
  bool available = true;      // false: no generator, and the original's data is not there
  std::string source;         // the original's file, or the generator
  std::string credit;         // of the original; empty for procedural scenes
  std::string home_url;       // public home of the original's archive; empty for procedural scenes
  u32 frames = 400;
  bool has_generator = false;  // a triangle count may be asked for
  std::string paper_json;      // the manifest's `paper` object (checked) as JSON text; empty if there is none
};

class UnknownScene : public std::runtime_error {
 public:
  UnknownScene(std::string_view name, std::vector<std::string> known);
  const std::vector<std::string>& known() const { return known_; }

 private:
  std::vector<std::string> known_;
};

/// All scenes of the folder, by name. `data_dir` is where original data may lie; it need not exist.
/// Throws std::runtime_error naming the file and the JSON pointer of a bad manifest.
std::vector<SceneInfo> list_scenes(const std::filesystem::path& scenes_dir, const std::filesystem::path& data_dir);

/// Loads the original if its file is present, else generates. With `triangles` it always generates, exactly that many.
/// Without `decode` all textures are missing.
/// Throws UnknownScene; std::invalid_argument if the scene cannot have that many triangles; std::runtime_error for a
/// bad manifest or data file.
Scene load_scene(std::string_view name, const std::filesystem::path& scenes_dir, const std::filesystem::path& data_dir,
                 std::optional<u64> triangles = std::nullopt, DecodeTexture decode = {});

}  // namespace raywalk
