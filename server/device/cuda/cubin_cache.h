// Compiled kernels on disk, one file a key; several processes may share the folder.
#pragma once
#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "server/device/cuda/compiler.h"

namespace raywalk::cuda {

/// Trouble with the folder costs time only: it is logged (once, where it cannot be written) and never thrown.
class CubinCache {
 public:
  /// Makes `dir` when it is missing. Empty: nothing is kept.
  explicit CubinCache(std::filesystem::path dir);

  /// What was stored under `key`; nothing when there is no such file, or it is not exactly what `store` wrote.
  std::optional<Compiled> load(const std::string& key) const;
  /// Whole or not at all, whatever other processes do. `key` is fit for a file's name.
  void store(const std::string& key, const Compiled& compiled) const;
  std::filesystem::path file_of(const std::string& key) const;

 private:
  void cannot_write(const std::string& reason) const;

  std::filesystem::path dir_;
  mutable std::atomic<bool> warned_ = false;
};

}  // namespace raywalk::cuda
