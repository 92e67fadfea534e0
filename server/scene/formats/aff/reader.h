// All statements of an AFF file and of those that it includes.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/scene/formats/aff/mesh.h"
#include "server/scene/formats/aff/shapes.h"

namespace raywalk::aff {

class Reader {
 public:
  explicit Reader(ImportFiles& files);
  /// Throws std::runtime_error naming file and line.
  Scene read();

 private:
  /// A statement that opens a block with braces leaves it open.
  struct Statement {
    std::string_view word;
    void (Reader::*read)(Text&);
  };
  struct View {
    glm::dvec3 from, at, up;
    double angle_deg;
  };
  struct Timetable {
    double start, end;
  };
  static const Statement* find(std::string_view word);

  void read_file(const std::filesystem::path& file, const std::string& named_at);
  const std::string& content_of(const std::filesystem::path& file);
  void read_statements(Text& text);
  void close_block(Text& text, size_t depth_of_file);
  void finish();

  void read_view(Text& text);
  void read_light(Text& text);
  void read_named_light(Text& text);
  void read_background(Text& text);
  void read_ambient(Text& text);
  void read_fill(Text& text) { materials_.read_fill(text); }
  void read_full_fill(Text& text) { materials_.read_full_fill(text); }
  void read_sphere(Text& text) { shapes_.read_sphere(text); }
  void read_cone(Text& text) { shapes_.read_cone(text); }
  void read_flat_polygon(Text& text) { shapes_.read_polygon(text, false); }
  void read_smooth_polygon(Text& text) { shapes_.read_polygon(text, true); }
  void read_flat_triangle(Text& text) { shapes_.read_textured_triangle(text, false); }
  void read_smooth_triangle(Text& text) { shapes_.read_textured_triangle(text, true); }
  void read_animated_triangle(Text& text) { shapes_.read_animated_triangle(text); }
  void read_mesh(Text& text) { aff::read_mesh(text, geometry_, materials_); }
  void read_include(Text& text);
  void read_detail(Text& text);
  void read_fixed_block(Text& text);
  void read_animated_block(Text& text);
  void read_timetable(Text& text);
  void read_keyframes(Text& text);
  Vec3 optional_color(Text& text);

  ImportFiles& files_;
  SceneBuilder builder_;
  Materials materials_;
  Geometry geometry_;
  Shapes shapes_;
  Geometry::KeyframesOfName keyframes_;
  std::optional<View> view_;
  std::optional<Timetable> timetable_;
  long long detail_ = 0;
  std::map<std::filesystem::path, std::string> contents_;
  std::vector<std::filesystem::path> including_;  // the files being read, outermost first
  u64 includes_ = 0, bytes_left_;
  bool understood_ = false;  // some statement
};

}  // namespace raywalk::aff
