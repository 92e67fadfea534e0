// The knobs of kernels/knobs.h as options of a traversal.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "kernels/accel/kind.h"
#include "kernels/entry_cpu.h"
#include "kernels/shade/spawn.h"

namespace raywalk {

/// A row of a list in kernels/knobs.h.
struct KnobRow {
  std::string_view type;  // in the kernels
  std::string_view name;  // on the wire
};
const std::vector<KnobRow>& intersector_rows();
const std::vector<KnobRow>& slab_rows();
const std::vector<KnobRow>& node_rows();
const std::vector<KnobRow>& spawn_rows();

/// intersector; slab and stack_entries where `traversal_knobs` (kKnobSlab, kKnobStack) has them; spawn.
std::vector<Option> knob_options(u32 traversal_knobs);

/// Where a ray towards `d` starts that leaves `surface`, by the row of spawn_rows(). Throws std::invalid_argument
/// when there is no such row.
using SpawnOrigin = Vec3 (*)(const Surface& surface, Vec3 d);
SpawnOrigin spawn_origin_of(u32 spawn);

/// Defaults for what `options` leaves out; options that are no knobs are left alone.
Knobs knobs_of(const OptionValues& options);

/// Why a traversal with these options cannot use a structure of that form, as a sentence; empty when it can.
std::string why_unfit(const StructureForm& form, const OptionValues& options);
/// Throws std::invalid_argument for that reason; `what` is the technique or structure, for people.
void check_form(const std::string& what, const StructureForm& form, const OptionValues& options);

}  // namespace raywalk
