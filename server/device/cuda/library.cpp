// dlopen with reasons.
#include "server/device/cuda/library.h"

#include <dlfcn.h>
#include <link.h>

#include <filesystem>
#include <string_view>

namespace raywalk::cuda {

namespace {

/// A loaded library, to be found among all, and its build identifier.
struct Loaded {
  ElfW(Addr) base = 0;
  std::string build_id;  // bytes
};

/// Of a segment of notes: names and contents follow their header, each filled up to four bytes.
std::string build_id_in(std::string_view notes) {
  const auto filled = [](size_t size) { return (size + 3) / 4 * 4; };
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    const auto& note = *reinterpret_cast<const ElfW(Nhdr)*>(notes.data());
    notes.remove_prefix(sizeof note);
    const size_t name = filled(note.n_namesz), size = filled(note.n_descsz);
    if (name + size > notes.size()) break;
    if (note.n_type == NT_GNU_BUILD_ID) return std::string(notes.substr(name, note.n_descsz));
    notes.remove_prefix(name + size);
  }
  return {};
}

int find_build_id(dl_phdr_info* info, size_t /*size*/, void* data) {
  Loaded& wanted = *static_cast<Loaded*>(data);
  if (info->dlpi_addr != wanted.base) return 0;
  for (const ElfW(Phdr) & segment : std::span(info->dlpi_phdr, info->dlpi_phnum)) {
    if (segment.p_type != PT_NOTE || !wanted.build_id.empty()) continue;
    wanted.build_id = build_id_in({reinterpret_cast<const char*>(info->dlpi_addr + segment.p_vaddr), segment.p_memsz});
  }
  return 1;
}

}  // namespace

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

std::string Library::identity() const {
  const link_map* map = nullptr;
  if (dlinfo(handle_, RTLD_DI_LINKMAP, &map) != 0) return path_;
  std::error_code error;
  const std::filesystem::path file = std::filesystem::canonical(map->l_name, error);
  Loaded loaded{map->l_addr, {}};
  dl_iterate_phdr(find_build_id, &loaded);
  std::string text = file.filename().string() + ' ' + std::to_string(std::filesystem::file_size(file, error)) + ' ';
  for (const char byte : loaded.build_id) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    text += {kDigits[static_cast<unsigned char>(byte) >> 4], kDigits[byte & 15]};
  }
  return text;
}

}  // namespace raywalk::cuda
