// The table of formats by the names of their files, and the file that stands for the bytes.
#include "tests/fuzz/formats.h"

#include <fstream>
#include <stdexcept>

#include "tests/support/folder.h"

namespace raywalk {

#define RAYWALK_FUZZ_FORMAT(name) extern const Format k_##name##_format;
#include "fuzz_formats.inc"
#undef RAYWALK_FUZZ_FORMAT

namespace fuzz {
namespace {

constexpr ImportLimits kSmall{100'000, 16u << 20};

/// A texel where the file is of even length, and none where it is odd, so that both ways are taken.
Texture decode(std::span<const u8> bytes) {
  if (bytes.size() % 2 == 1) throw std::runtime_error("an odd length");
  return {"", 1, 1, {0}};
}

}  // namespace

std::span<const NamedFormat> named_formats() {
  static const std::vector<NamedFormat> all = {
#define RAYWALK_FUZZ_FORMAT(name) {#name, &k_##name##_format},
#include "fuzz_formats.inc"
#undef RAYWALK_FUZZ_FORMAT
  };
  return all;
}

const Format& format_named(const std::string& name) {
  for (const NamedFormat& named : named_formats()) {
    if (named.name == name) return *named.format;
  }
  throw std::invalid_argument("there is no format '" + name + "'");
}

void try_load(const Format& format, std::span<const u8> bytes) {
  static const test::Folder folder;
  // Files of one format include themselves by this name.
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::filesystem::path file = folder.write("scene" + std::string(format.extensions[0]), text);
  format.begins(bytes.first(std::min<size_t>(bytes.size(), 1024)));
  try {
    ImportFiles files(file, {.root = folder.path(), .decode = decode, .limits = kSmall});
    Scene scene = format.load(files);
    pack(scene);
  } catch (const std::runtime_error&) {
  }
}

}  // namespace fuzz
}  // namespace raywalk
