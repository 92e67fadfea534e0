// dlopen with reasons.
#include "server/device/cuda/library.h"

#include <dlfcn.h>

namespace raywalk::cuda {

Found<Library> Library::open(std::span<const std::string> names) {
  std::string tried;
  for (const std::string& name : names) {
    if (void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) {
      return {std::shared_ptr<const Library>(new Library(handle, name)), {}};
    }
    const char* reason = dlerror();
    if (!tried.empty()) tried += "; ";
    tried += name + " (" + (reason != nullptr ? reason : "no reason given") + ")";
  }
  return {nullptr, tried.empty() ? "There is no library to open." : "None of these can be opened: " + tried + "."};
}

Library::~Library() {
  dlclose(handle_);
}

void* Library::symbol(const char* name) const {
  return dlsym(handle_, name);
}

}  // namespace raywalk::cuda
