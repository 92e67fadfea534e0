// scenes/<name>/scene.json, read and checked.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "server/scene/scene.h"

namespace raywalk {

struct OriginalSource {
  std::filesystem::path file;  // inside the folder of original data, with forward slashes
  std::string sha256;          // of its uncompressed contents
  u64 triangles;
  Fidelity fidelity;  // kOriginal or kDerived
  std::string credit;
  std::string home_url;
};

struct GeneratorSource {
  std::string name;
  u64 triangles;
};

/// An orbit whose size follows the scene's bounds.
struct OrbitPlan {
  std::optional<Vec3> centre;  // of the bounds when absent
  float radius_factor;         // times half the diagonal of the bounds
  float elevation_deg, start_deg, turns, vertical_fov_deg;
};

struct Manifest {
  std::string name;  // of the folder
  std::string title, prose;
  std::optional<OriginalSource> original;
  std::optional<GeneratorSource> generator;  // at least one of the two is there
  std::vector<Material> materials;
  std::vector<Light> lights;
  Vec3 ambient, background;
  std::variant<OrbitPlan, SplinePath> camera;
  u32 frames;
  std::string paper_json;

  CameraPath camera_path(const Box& bounds) const;
};

/// Throws std::runtime_error naming the file, and the JSON pointer of what is wrong.
Manifest read_manifest(const std::filesystem::path& file);

}  // namespace raywalk
