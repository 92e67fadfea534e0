// Host only: what a structure kind tells the rest of the program: its name, its build options and its builder.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/accel/records.h"
#include "kernels/blob_writer.h"
#include "kernels/scene_view.h"

namespace raywalk {

/// One build option. A choice option's value is the index of the choice.
struct Option {
  std::string_view name;
  std::string_view help;
  double default_value = 0;
  double min = 0, max = 0;
  bool integer = false;
  double step = 0;  // the value is a multiple of it; 0: any
  std::vector<std::string_view> choices = {};
};

/// Complete: every option of the kind is present and inside its range (see `with_defaults`).
using OptionValues = std::map<std::string, double, std::less<>>;

struct BuildStats {
  u64 nodes = 0;       // inner nodes and leaves; cells for a grid
  u64 leaves = 0;      // cells for a grid
  u64 references = 0;  // triangle references in leaves or cells
  u64 size_bytes = 0;  // of the blob
  u32 max_depth = 0;
  u32 resolution[3] = {0, 0, 0};  // grid cells along x, y, z
  double sah_cost = 0;            // expected cost of a random ray, in the kind's own units; 0 where it has none
  double build_ms = 0;
};

/// What a kernel must be compiled for to read a structure.
struct StructureForm {
  TriangleRecords triangles = TriangleRecords::corners;
  u32 nodes = 0;  // a row of RW_NODE_FORMATS
};

struct BuiltStructure {
  Blob blob;
  BuildStats stats;
  StructureForm form;
};

struct Kind {
  std::string_view name;
  std::string_view help;
  std::vector<Option> options;
  /// Deterministic: the same scene and options give the same bytes, whatever the number of threads.
  BuiltStructure (*build)(SceneView scene, const OptionValues& options);
};

/// Fills in defaults. Throws std::invalid_argument that names the option when one is unknown, out of range, not whole
/// or not a multiple of its step.
OptionValues with_defaults(const Kind& kind, const OptionValues& given);

/// All kinds of the kernels, in the order of the documentation.
const std::vector<const Kind*>& kinds();

}  // namespace raywalk
