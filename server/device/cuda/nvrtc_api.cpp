// Looks for NVRTC and opens it.
#include "server/device/cuda/nvrtc_api.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "server/device/cuda/driver_api.h"
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

/// The package of Python that has NVRTC for drivers of a major version of CUDA.
std::string wheel_for(int major) {
  return major < 13 ? "nvidia-cuda-nvrtc-cu" + std::to_string(major)
                    : "nvidia-cuda-nvrtc==" + std::to_string(major) + ".*";
}

Found<NvrtcApi> checked(const std::shared_ptr<const Library>& library, int driver_version) {
  const auto api = std::make_shared<NvrtcApi>();
  api->library = library;
  std::string missing;
#define RW_BIND(call, ...) bind(*library, #call, api->call, missing);
  RW_NVRTC_CALLS(RW_BIND)
#undef RW_BIND
  bind(*library, "nvrtcGetErrorString", api->nvrtcGetErrorString, missing);
  const std::string where = "The kernel compiler NVRTC (" + library->path() + ") ";
  // The version first: it is a better reason than calls that are missing.
  if (api->nvrtcVersion != nullptr && api->nvrtcVersion(&api->major, &api->minor) != NVRTC_SUCCESS) {
    return {nullptr, where + "does not tell its version."};
  }
  const int version = 1000 * api->major + 10 * api->minor;
  if (api->nvrtcVersion != nullptr && version < kOldestNvrtc) {
    return {nullptr, where + "is too old: it is " + api->version() + ", and " + version_text(kOldestNvrtc) +
                         " or newer is needed."};
  }
  const int driver_major = driver_version / 1000;
  if (driver_version != 0 && api->major > driver_major) {
    return {nullptr, where + "is too new for the driver: it is " + api->version() + ", and the driver supports CUDA " +
                         version_text(driver_version) + "; pip install \"" + wheel_for(driver_major) +
                         "\" brings one that fits."};
  }
  if (!missing.empty()) return {nullptr, where + "lacks " + missing + "."};
  api->identity = library->identity();
  api->builtins = open_builtins(*api);
  return {api, {}};
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

std::string joined(const std::vector<std::string>& architectures) {
  std::string all;
  for (const std::string& name : architectures) all += (all.empty() ? "" : ", ") + name;
  return all;
}

std::vector<std::string> nvrtc_places() {
  std::vector<std::string> names;
  std::istringstream named(environment("RAYWALK_NVRTC"));
  for (std::string name; std::getline(named, name, ':');) {
    if (!name.empty()) names.push_back(name);
  }
  if (!names.empty()) return names;
  names = {"libnvrtc.so.13", "libnvrtc.so.12"};
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

Found<NvrtcApi> open_nvrtc(int driver_version) {
  const std::vector<std::string> places = nvrtc_places();
  std::string unfit;
  for (const std::string& place : places) {
    const Found<Library> library = Library::open({&place, 1}, Library::Unload::never);
    if (!library) continue;
    Found<NvrtcApi> nvrtc = checked(library.value, driver_version);
    if (nvrtc) return nvrtc;
    unfit += (unfit.empty() ? "" : " ") + nvrtc.why_not;
  }
  if (!unfit.empty()) return {nullptr, unfit};
  return {nullptr, "There is no kernel compiler (NVRTC). " + Library::open(places).why_not};
}

}  // namespace raywalk::cuda
