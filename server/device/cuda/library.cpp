// dlopen with reasons.
#include "server/device/cuda/library.h"

#include <dlfcn.h>

namespace raywalk::cuda {

Found<Library> Library::open(std::span<const std::string> names, Unload unload) {
  const int flags = RTLD_NOW | RTLD_LOCAL | (unload == Unload::never ? RTLD_NODELETE : 0);
  std::string tried;
  for (const std::string& name : names) {
    if (void* handle = dlopen(name.c_str(), flags)) {
      return {std::shared_ptr<const Library>(new Library(handle, name)), {}};
    }
    const char* reason = dlerror();  // begins with the name
    tried += (tried.empty() ? "" : "; ") + (reason != nullptr ? std::string(reason) : name);
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
