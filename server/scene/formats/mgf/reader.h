// MGF read statement by statement.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "server/scene/formats/mgf/contexts.h"
#include "server/scene/formats/mgf/emitters.h"
#include "server/scene/formats/mgf/geometry.h"
#include "server/scene/formats/mgf/material.h"
#include "server/scene/formats/mgf/statements.h"
#include "server/scene/formats/mgf/transform.h"

namespace raywalk {

class MgfReader {
 public:
  using Words = std::span<const std::string_view>;

  explicit MgfReader(ImportFiles& files);
  /// Once. Throws std::runtime_error naming file and line.
  Scene read();

 private:
  /// One kind of statement: what it is called, how many arguments it takes, what it does.
  struct Entity {
    std::string_view name;
    size_t least, most;
    void (MgfReader::*run)(Words arguments);
  };
  struct Source {
    std::filesystem::path path;
    std::string text;
  };
  /// An `xf` that is open, or the transformation of an include.
  struct Frame {
    MgfTransform transform;
    glm::dmat4 total;                   // with all that are outside
    const StatementReader* statements;  // where it was opened; null for an include
    StatementReader::Mark begin;
    u64 line;
    bool again = false;  // beyond the first member
  };

  static std::span<const Entity> entities();
  const Source& source(const std::filesystem::path& path);
  void run(const Source& source);
  void execute(Words words);
  void charge(u64 bytes);
  void warn(const std::string& message) { builder_.warn(at_line(place_.file, place_.line), message); }

  // xf, i and o (reader.cpp)
  void open_frame(Words arguments, const StatementReader* statements);
  bool next_member();
  void close_frame();
  void place();
  void transform(Words arguments);
  void include(Words arguments);
  void object(Words arguments);
  void skip(Words arguments);

  // Colours, materials and vertices (reader_contexts.cpp)
  void color(Words arguments);
  void color_xy(Words arguments);
  void color_spectrum(Words arguments);
  void color_temperature(Words arguments);
  void color_mixture(Words arguments);
  void material(Words arguments);
  void sides(Words arguments);
  void diffuse(Words arguments);
  void translucent(Words arguments);
  void emitted(Words arguments);
  void specular(Words arguments);
  void transparent(Words arguments);
  void refraction(Words arguments);
  void vertex(Words arguments);
  void point(Words arguments);
  void normal(Words arguments);
  MgfMaterial::Term term(Words arguments);

  // Surfaces (reader_surfaces.cpp)
  template <class Add>
  void surface(Add add);
  u32 index_of(MgfMaterial& material);
  void face(Words arguments);
  void sphere(Words arguments);
  void cylinder(Words arguments);
  void cone(Words arguments);
  void ring(Words arguments);
  void torus(Words arguments);
  void prism(Words arguments);
  std::span<const MgfVertex> corners(Words names);

  ImportFiles& files_;
  SceneBuilder builder_;
  MgfGeometry geometry_;
  MgfEmitters emitters_;
  std::map<std::filesystem::path, Source> sources_;
  MgfContexts<MgfColor> colors_{"colour"};
  MgfContexts<MgfMaterial> materials_{"material"};
  MgfContexts<MgfVertex> vertices_{"vertex"};
  std::map<std::string, u32> index_of_;  // of materials, by their bytes

  struct {
    std::filesystem::path file;
    u64 line = 0;
  } place_;
  StatementReader* statements_ = nullptr;  // of the innermost file
  std::vector<const Source*> open_files_;
  std::vector<Frame> frames_;
  std::vector<u64> objects_;  // that are open
  u64 last_object_ = 0;
  u64 repeating_ = 0;  // arrays beyond their first member, and files read again, that are open
  u64 work_left_;
  std::vector<MgfVertex> corners_;
};

}  // namespace raywalk
