// A shared library that may be missing: opened at run time, its functions filled in from one list.
#pragma once
#include <memory>
#include <span>
#include <string>

namespace raywalk::cuda {

/// Either a value or the reason why there is none, one sentence for people.
template <class T>
struct Found {
  std::shared_ptr<const T> value;
  std::string why_not;
  explicit operator bool() const { return value != nullptr; }
};

/// Opens the first of `names` (paths or names for the loader) that can be opened; closes it when destroyed.
class Library {
 public:
  /// Some libraries do not survive that, or lose what they hold: they stay in the process.
  enum class Unload { when_closed, never };

  /// Null with a reason that names what was tried and why it failed.
  static Found<Library> open(std::span<const std::string> names, Unload unload = Unload::when_closed);
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  /// Null when it has no such symbol.
  void* symbol(const char* name) const;
  const std::string& path() const { return path_; }
  /// Differs between builds of a library that tell the same version: the file's name and size, and the linker's build
  /// identifier where it has one.
  std::string identity() const;

 private:
  Library(void* handle, std::string path) : handle_(handle), path_(std::move(path)) {}
  void* handle_;
  std::string path_;
};

/// Sets `function` to the library's `symbol`; when there is none, adds its name to `missing`.
template <class Function>
void bind(const Library& library, const char* symbol, Function*& function, std::string& missing) {
  function = reinterpret_cast<Function*>(library.symbol(symbol));
  if (function == nullptr) missing += (missing.empty() ? "" : ", ") + std::string(symbol);
}

}  // namespace raywalk::cuda
