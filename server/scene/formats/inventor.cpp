// Open Inventor 1.0 and 2.x (ascii) and VRML 1.0: the subset that is listed with its interpreter.
#include "server/scene/formats/formats.h"
#include "server/scene/formats/inventor/interpreter.h"

namespace raywalk {
namespace {

bool begins_as_inventor(std::span<const u8> head) {
  const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
  return text.starts_with("#Inventor V") || text.starts_with("#VRML V");
}

Scene load_inventor(ImportFiles& files) {
  return IvInterpreter(files).read();
}

}  // namespace

extern const Format k_inventor_format;
const Format k_inventor_format = {"Open Inventor", {".iv", ".wrl"}, begins_as_inventor, load_inventor};

}  // namespace raywalk
