// Corners of faces into shared vertices.
#include "server/scene/formats/obj/vertices.h"

#include <stdexcept>

#include "server/scene/formats/obj/lines.h"

namespace raywalk {
namespace {

constexpr u32 kLongestSearch = 16;  // vertices at one position; beyond it they are no longer shared

/// From 0. Positive indices count from 1, negative ones back from the end.
u32 resolved(std::string_view word, size_t count, const char* what) {
  long long index = 0;
  if (!parse_number(word, index)) throw std::runtime_error(in_quotes(word) + " is not an index");
  const long long size = static_cast<long long>(count);
  const long long from_zero = index > 0 ? index - 1 : index + size;
  if (index == 0 || from_zero < 0 || from_zero >= size) {
    throw std::runtime_error(std::string(what) + " " + std::to_string(index) + " is out of range: there are " +
                             std::to_string(count) + " so far");
  }
  return static_cast<u32>(from_zero);
}

}  // namespace

void ObjVertices::add_position(Vec3 position) {
  if (positions_.size() == kNone) throw std::runtime_error("more than 2^32 - 1 vertices");
  positions_.push_back(position);
  first_.push_back(kNone);
}

u32 ObjVertices::corner(std::string_view word) {
  const size_t slash = word.find('/');
  const u32 position = resolved(word.substr(0, slash), positions_.size(), "vertex");
  u32 texcoord = kNone, normal = kNone;
  if (slash != word.npos) {
    const std::string_view rest = word.substr(slash + 1);
    const size_t second = rest.find('/');
    const std::string_view texcoord_word = rest.substr(0, second);
    if (!texcoord_word.empty()) texcoord = resolved(texcoord_word, texcoords_.size(), "texture coordinate");
    if (second != rest.npos && second + 1 < rest.size()) {
      normal = resolved(rest.substr(second + 1), normals_.size(), "normal");
    }
  }

  u32 steps = 0;
  for (u32 at = first_[position]; at != kNone && steps < kLongestSearch; at = used_[at].next, ++steps) {
    if (used_[at].texcoord == texcoord && used_[at].normal == normal) return at;
  }
  MeshCorner vertex{positions_[position], {}, {}};
  if (normal != kNone) vertex.normal = normals_[normal];
  if (texcoord != kNone) vertex.texcoord = texcoords_[texcoord];
  const u32 added = builder_.add_vertex(vertex);
  used_.push_back({texcoord, normal, first_[position]});
  return first_[position] = added;
}

}  // namespace raywalk
