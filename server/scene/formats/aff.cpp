// AFF, the format of the BART scenes, an extension of NFF.
#include "server/scene/formats/aff/reader.h"
#include "server/scene/formats/formats.h"

namespace raywalk {
namespace {

bool take_numbers(aff::Text& text, int least, int most) {
  int taken = 0;
  for (; taken < most && text.next_is_number(); ++taken) text.word();
  return taken >= least;
}

/// A view, perhaps behind the statements that often come first; other formats have no such words in this order.
bool begins(std::span<const u8> head) {
  const std::filesystem::path nowhere;
  aff::Text text(nowhere, {reinterpret_cast<const char*>(head.data()), head.size()});
  for (std::string_view word = text.word();; word = text.word()) {
    if (word == "v") return text.word() == "from" && take_numbers(text, 3, 3);
    const bool known = word == "b" || word == "am" || word == "l" || word == "a";
    if (!known || !take_numbers(text, 3, 6)) return false;
  }
}

Scene load(ImportFiles& files) {
  return aff::Reader(files).read();
}

}  // namespace

extern const Format k_aff_format;
const Format k_aff_format{"AFF", {".aff", ".nff"}, begins, load};

}  // namespace raywalk
