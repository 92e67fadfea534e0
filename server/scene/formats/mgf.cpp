// MGF, the Materials and Geometry Format (G. Ward, LBNL, 1995): rooms with physical materials and lamps.
#include "server/scene/formats/formats.h"
#include "server/scene/formats/mgf/reader.h"

namespace raywalk {
namespace {

/// Nothing in a file of MGF says so: its extension must.
bool begins(std::span<const u8>) {
  return false;
}

Scene load(ImportFiles& files) {
  return MgfReader(files).read();
}

}  // namespace

extern const Format k_mgf_format;
const Format k_mgf_format{"MGF", {".mgf"}, begins, load};

}  // namespace raywalk
