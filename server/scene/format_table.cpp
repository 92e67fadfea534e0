// The table of formats, which CMake collects from the folder.
#include "server/scene/formats/formats.h"

namespace raywalk {

#define RAYWALK_FORMAT(name) extern const Format k_##name##_format;
#include "format_list.inc"
#undef RAYWALK_FORMAT

std::span<const Format* const> formats() {
  static constexpr const Format* kFormats[] = {
#define RAYWALK_FORMAT(name) &k_##name##_format,
#include "format_list.inc"
#undef RAYWALK_FORMAT
  };
  return kFormats;
}

}  // namespace raywalk
