// The table of mesh formats; one file a format.
#pragma once
#include <span>

#include "server/scene/byte_reader.h"
#include "server/scene/scene.h"

namespace raywalk {

struct Format {
  const char* name;
  const char* extension;  // lower case, without ".gz"
  /// Whether the (uncompressed) beginning of a file is this format beyond doubt.
  bool (*begins)(std::span<const u8> head);
  /// Fills positions, normals, triangles, warnings, and materials if the format has them.
  Scene (*load)(ByteReader& reader);
};

extern const Format kPly;

}  // namespace raywalk
