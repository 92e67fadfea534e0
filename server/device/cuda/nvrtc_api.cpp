// Looks for NVRTC and opens it.
#include "server/device/cuda/nvrtc_api.h"

#include <algorithm>
#include <filesystem>

#include "server/device/cuda/environment.h"

namespace raywalk::cuda {
namespace {

namespace fs = std::filesystem;

/// The entries of a folder in order of their names, newest version first; none when it cannot be read.
std::vector<fs::path> entries(const fs::path& folder, const std::string& prefix) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().filename().string().starts_with(prefix)) found.push_back(entry.path());
  }
  std::sort(found.rbegin(), found.rend());
  return found;
}

void add_libraries(const fs::path& folder, std::vector<std::string>& names) {
  for (const fs::path& library : entries(folder, "libnvrtc.so.")) names.push_back(library);
}

/// Where Python's wheels put it: lib/python3.x/site-packages/nvidia/<package>/lib.
void add_python_environment(const fs::path& environment, std::vector<std::string>& names) {
  for (const fs::path& python : entries(environment / "lib", "python3")) {
    for (const fs::path& package : entries(python / "site-packages" / "nvidia", "")) {
      add_libraries(package / "lib", names);
    }
  }
}

/// The program may lie in build/release/server of a source tree.
constexpr int kFoldersAbove = 4;

/// NVRTC opens its built-in functions by name when it compiles: opened from beside it before, they are found.
std::shared_ptr<const Library> open_builtins(const NvrtcApi& nvrtc) {
  const fs::path path = nvrtc.library->path();
  if (!path.has_parent_path()) return nullptr;
  const std::string name = "libnvrtc-builtins.so." + nvrtc.version();
  std::error_code error;
  const std::vector<std::string> names = {path.parent_path() / name, fs::canonical(path, error).parent_path() / name};
  return Library::open(names).value;
}

}  // namespace

std::vector<std::string> NvrtcApi::architectures() const {
  int count = 0;
  if (nvrtcGetNumSupportedArchs(&count) != NVRTC_SUCCESS) return {};
  std::vector<int> numbers(static_cast<size_t>(count));
  if (nvrtcGetSupportedArchs(numbers.data()) != NVRTC_SUCCESS) return {};
  std::vector<std::string> names;
  for (const int number : numbers) names.push_back("sm_" + std::to_string(number));
  return names;
}

std::vector<std::string> nvrtc_places() {
  if (std::string named = environment("RAYWALK_NVRTC"); !named.empty()) return {std::move(named)};
  std::vector<std::string> names = {"libnvrtc.so.13", "libnvrtc.so.12"};
  for (const fs::path& toolkit : entries("/usr/local", "cuda")) add_libraries(toolkit / "lib64", names);
  if (const std::string active = environment("VIRTUAL_ENV"); !active.empty()) add_python_environment(active, names);
  std::error_code error;
  fs::path folder = fs::read_symlink("/proc/self/exe", error);
  for (int i = 0; i < kFoldersAbove && folder.has_relative_path(); ++i) {
    folder = folder.parent_path();
    add_python_environment(folder / ".venv", names);
  }
  return names;
}

Found<NvrtcApi> open_nvrtc() {
  const Found<Library> library = Library::open(nvrtc_places(), Library::Unload::never);
  if (!library) return {nullptr, "There is no kernel compiler (NVRTC). " + library.why_not};

  const auto api = std::make_shared<NvrtcApi>();
  api->library = library.value;
  std::string missing;
#define RW_BIND(call, ...) bind(*library.value, #call, api->call, missing);
  RW_NVRTC_CALLS(RW_BIND)
#undef RW_BIND
  bind(*library.value, "nvrtcGetErrorString", api->nvrtcGetErrorString, missing);
  const std::string where = "The kernel compiler NVRTC (" + library.value->path() + ") ";
  if (!missing.empty()) return {nullptr, where + "lacks " + missing + "."};
  if (api->nvrtcVersion(&api->major, &api->minor) != NVRTC_SUCCESS) {
    return {nullptr, where + "does not tell its version."};
  }
  api->builtins = open_builtins(*api);
  return {api, {}};
}

}  // namespace raywalk::cuda
