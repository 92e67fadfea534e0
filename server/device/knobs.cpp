// Lists of knobs as data, and their values out of options.
#include "server/device/knobs.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

#include "kernels/accel/traversals.h"

namespace raywalk {
namespace {

#define RW_KNOB_ROW(type, name, help) {#type, name},
#define RW_KNOB_HELP(type, name, help) "; " name ": " help
constexpr std::string_view kIntersectorHelp = "ray-triangle test" RW_INTERSECTORS(RW_KNOB_HELP);
constexpr std::string_view kSlabHelp = "ray-box test" RW_SLAB_TESTS(RW_KNOB_HELP);
constexpr std::string_view kSpawnHelp = "where rays start that leave a surface" RW_SPAWN_OFFSETS(RW_KNOB_HELP);
#undef RW_KNOB_HELP

Option choice(std::string_view name, std::string_view help, const std::vector<KnobRow>& rows) {
  Option option{.name = name, .help = help, .integer = true};
  for (const KnobRow& row : rows) option.choices.push_back(row.name);
  return option;
}

/// What each intersector reads.
#define RW_KNOB_RECORDS(type, name, help) kRecords<RecordOf<type>::Type>,
constexpr TriangleRecords kIntersectorRecords[] = {RW_INTERSECTORS(RW_KNOB_RECORDS)};
#undef RW_KNOB_RECORDS

const char* name_of(TriangleRecords records) {
  return records == TriangleRecords::corners ? "corners" : "transforms";
}

}  // namespace

const std::vector<KnobRow>& intersector_rows() {
  static const std::vector<KnobRow> rows = {RW_INTERSECTORS(RW_KNOB_ROW)};
  return rows;
}
const std::vector<KnobRow>& slab_rows() {
  static const std::vector<KnobRow> rows = {RW_SLAB_TESTS(RW_KNOB_ROW)};
  return rows;
}
const std::vector<KnobRow>& node_rows() {
  static const std::vector<KnobRow> rows = {RW_NODE_FORMATS(RW_KNOB_ROW)};
  return rows;
}
const std::vector<KnobRow>& spawn_rows() {
  static const std::vector<KnobRow> rows = {RW_SPAWN_OFFSETS(RW_KNOB_ROW)};
  return rows;
}
#undef RW_KNOB_ROW

std::vector<Option> knob_options(u32 traversal_knobs) {
  std::vector<Option> options = {choice("intersector", kIntersectorHelp, intersector_rows())};
  if ((traversal_knobs & kKnobSlab) != 0) options.push_back(choice("slab", kSlabHelp, slab_rows()));
  if ((traversal_knobs & kKnobStack) != 0) {
    options.push_back({.name = "stack_entries",
                       .help = "entries of the short stack; a full one forgets the oldest and restarts later",
                       .default_value = kStackEntries,
                       .min = 1,
                       .max = kMaxStackEntries,
                       .integer = true});
  }
  options.push_back(choice("spawn", kSpawnHelp, spawn_rows()));
  return options;
}

SpawnOrigin spawn_origin_of(u32 spawn) {
#define RW_SPAWN_ORIGIN(type, name, help) &type::origin,
  static constexpr SpawnOrigin kOrigins[] = {RW_SPAWN_OFFSETS(RW_SPAWN_ORIGIN)};
#undef RW_SPAWN_ORIGIN
  if (spawn >= std::size(kOrigins)) throw std::invalid_argument("no spawn offset has number " + std::to_string(spawn));
  return kOrigins[spawn];
}

Knobs knobs_of(const OptionValues& options) {
  Knobs knobs;
  const auto take = [&](const char* name, u32& value) {
    const auto found = options.find(name);
    if (found != options.end()) value = static_cast<u32>(found->second);
  };
  take("intersector", knobs.intersector);
  take("slab", knobs.slab);
  take("spawn", knobs.spawn);
  take("stack_entries", knobs.stack_entries);
  return knobs;
}

std::string why_unfit(const StructureForm& form, const OptionValues& options) {
  const Knobs knobs = knobs_of(options);
  const TriangleRecords read = kIntersectorRecords[knobs.intersector];
  if (read != form.triangles)
    return "The intersector " + std::string(intersector_rows()[knobs.intersector].name) + " reads " + name_of(read) +
           ", and the structure was built with triangles=" + name_of(form.triangles) + ".";
  if (knobs.slab != 0 && form.nodes != 0)
    return "The slab test " + std::string(slab_rows()[knobs.slab].name) +
           " takes nodes=float alone, and the structure was built with nodes=" +
           std::string(node_rows()[form.nodes].name) + ".";
  return "";
}

void check_form(const std::string& what, const StructureForm& form, const OptionValues& options) {
  const std::string why = why_unfit(form, options);
  if (!why.empty()) throw std::invalid_argument(what + ": " + why);
}

}  // namespace raywalk
