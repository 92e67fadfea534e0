// Wavefront OBJ with materials (MTL): polygons; curves and surfaces are not read.
#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "server/scene/formats/formats.h"
#include "server/scene/formats/obj/lines.h"
#include "server/scene/formats/obj/materials.h"
#include "server/scene/formats/obj/vertices.h"

namespace raywalk {
namespace {

// Names, smoothing groups, parameters, points and lines: nothing that an image shows.
constexpr std::array<std::string_view, 7> kNoSurface = {"g", "o", "s", "mg", "vp", "p", "l"};

class ObjReader {
 public:
  explicit ObjReader(ImportFiles& files)
      : files_(files), builder_(files), vertices_(builder_), materials_(files, builder_) {}

  Scene read() {
    const std::string text = files_.read(files_.main());
    ObjLines lines(text);
    for (std::string_view line; lines.next(line);) {
      TokenReader words(line);
      const std::string_view word = words.next();
      if (word.empty()) continue;
      line_ = lines.number();
      try {
        statement(word, words, line);
      } catch (const std::runtime_error& e) {
        throw std::runtime_error(place() + ": " + e.what());
      }
    }
    if (builder_.scene().triangles.empty()) builder_.warn(files_.main().string(), "the file has no faces");
    return builder_.finish();
  }

 private:
  void statement(std::string_view word, TokenReader& words, std::string_view line) {
    if (word == "v") {
      vertices_.add_position(finite_vector(words));
    } else if (word == "f") {
      face(words);
    } else if (word == "vn") {
      vertices_.add_normal(finite_vector(words));
    } else if (word == "vt") {
      const float u = finite_number(words);
      TokenReader ahead = words;
      vertices_.add_texcoord(u, ahead.next().empty() ? 0.0f : finite_number(words));
    } else if (word == "usemtl") {
      material_ = materials_.use(rest_of(line, word), place());
    } else if (word == "mtllib") {
      libraries(rest_of(line, word));
    } else if (std::find(kNoSurface.begin(), kNoSurface.end(), word) == kNoSurface.end() &&
               unknown_.emplace(word).second) {
      builder_.warn(place(), "unknown statement " + in_quotes(word));
    }
  }

  void face(TokenReader& words) {
    corners_.clear();
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      corners_.push_back(vertices_.corner(word));
    }
    if (!material_) material_ = materials_.default_index();
    builder_.add_polygon(corners_, *material_);
  }

  /// One name with spaces in it, or several.
  void libraries(std::string_view names) {
    if (library(names)) return;
    TokenReader words(names);
    for (std::string_view name = words.next(); !name.empty(); name = words.next()) {
      if (!library(name)) builder_.warn(place(), "there is no material library " + in_quotes(name));
    }
  }
  bool library(std::string_view name) {
    std::optional<std::filesystem::path> file;
    try {
      file = files_.find(name, files_.main().parent_path());
    } catch (const std::runtime_error& e) {
      builder_.warn(place(), std::string(e.what()) + ": the material library is left out");
      return true;
    }
    if (file) materials_.read(*file);
    return file.has_value();
  }

  static std::string_view rest_of(std::string_view line, std::string_view word) {
    return trimmed(line.substr(static_cast<size_t>(word.data() + word.size() - line.data())));
  }
  std::string place() const { return at_line(files_.main(), line_); }

  ImportFiles& files_;
  SceneBuilder builder_;
  ObjVertices vertices_;
  MtlLibrary materials_;
  u64 line_ = 0;
  std::optional<u32> material_;
  std::vector<u32> corners_;
  std::set<std::string, std::less<>> unknown_;
};

bool begins_as_obj(std::span<const u8>) {
  return false;  // the format has no mark of its own
}

Scene load_obj(ImportFiles& files) {
  return ObjReader(files).read();
}

}  // namespace

extern const Format k_obj_format;
const Format k_obj_format = {"OBJ", {".obj"}, begins_as_obj, load_obj};

}  // namespace raywalk
