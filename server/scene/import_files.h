// The files that an import may read: the scene's own, and what it names beside it, inside one folder.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "server/scene/scene.h"

namespace raywalk {

/// Makes an image of the bytes of an image file. Throws std::runtime_error with the reason if it cannot.
using DecodeTexture = std::function<Texture(std::span<const u8> bytes)>;

/// What one import may use; beyond it the import fails.
struct ImportLimits {
  u64 triangles = 20'000'000;
  u64 bytes = 2ull << 30;  // of all files together, uncompressed
};

struct ImportSettings {
  std::filesystem::path root{};  // no file outside this folder is read; the file's own folder when empty
  DecodeTexture decode{};        // without it every texture is missing
  std::string extension{};       // of the name that the file had, such as ".obj", where its path has another
  ImportLimits limits{};
  u32 sphere_slices = 20, sphere_stacks = 10;  // of spheres in formats that leave their tessellation to the reader
  u32 cone_slices = 20;  // of AFF's cones; 0 leaves them out, as the published triangle counts of BART scenes do
};

class ImportFiles {
 public:
  ImportFiles(const std::filesystem::path& main, ImportSettings settings);

  /// The scene's file.
  const std::filesystem::path& main() const { return main_; }
  const ImportLimits& limits() const { return settings_.limits; }
  const ImportSettings& settings() const { return settings_; }

  /// The file `name` as a scene file in `folder` means it (slashes either way); nothing if there is none, or
  /// the folder itself lies outside the root.
  /// Throws std::runtime_error if the name is absolute, or leads out of the root, through a link too.
  std::optional<std::filesystem::path> find(std::string_view name, const std::filesystem::path& folder) const;
  /// All bytes of a file, gzip or plain. Throws std::runtime_error naming it if it cannot be read or the limit of bytes
  /// is passed.
  std::string read(const std::filesystem::path& file);
  /// Throws std::runtime_error with the reason.
  Texture decode(std::span<const u8> bytes) const;

 private:
  std::filesystem::path main_;
  ImportSettings settings_;
  std::filesystem::path root_;
  u64 bytes_left_;
};

}  // namespace raywalk
