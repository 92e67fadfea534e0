// One daemon a state folder.
#pragma once
#include <filesystem>

namespace raywalk::store {

/// Held while it lives; the kernel drops it with the process, however that ends.
class FolderLock {
 public:
  /// Throws std::runtime_error with a sentence for people when another process holds the folder, or the lock's file
  /// cannot be made.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace raywalk::store
