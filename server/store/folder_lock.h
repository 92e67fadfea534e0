// One daemon a state folder.
#pragma once
#include <filesystem>
#include <stdexcept>

namespace raywalk::store {

/// Another process holds the folder, or its lock cannot be made; a sentence for people.
class FolderError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Held while it lives; the kernel drops it with the process, however that ends.
class FolderLock {
 public:
  /// Throws FolderError.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace raywalk::store
