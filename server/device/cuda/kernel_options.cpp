// The options' ranges and defaults, and what they mean for the compiler.
#include "server/device/cuda/kernel_options.h"

#include "server/device/knobs.h"

namespace raywalk::cuda {
namespace {

// What all traversals run best with, or within 2 % of it (H100; tests/gpu/RESULTS.md): left alone, the compiler takes
// fewer registers than it could for some, and more than leave room for enough threads for others.
constexpr u32 kBlock = 128, kRegisters = 64;

constexpr u32 kWarp = 32, kMaxBlock = 512;
constexpr u32 kFewestRegisters = 24;  // the assembler silently raises a lower cap to it

}  // namespace

const TraversalType& traversal_type(const std::string& structure, const std::string& traversal) {
  for (const TraversalType& type : traversal_types())
    if (type.structure == structure && type.traversal == traversal) return type;
  throw std::invalid_argument(structure + " has no traversal " + traversal);
}

std::vector<Option> kernel_options(const TraversalType& type) {
  std::vector<Option> options = {{.name = "registers",
                                  .help = "most registers a thread, 24 to 255; 0 leaves it to the compiler",
                                  .default_value = kRegisters,
                                  .max = 255,
                                  .integer = true},
                                 {.name = "block",
                                  .help = "threads a block, a multiple of 32",
                                  .default_value = kBlock,
                                  .min = kWarp,
                                  .max = kMaxBlock,
                                  .integer = true,
                                  .step = kWarp}};
  for (Option& knob : knob_options(type.knobs)) options.push_back(std::move(knob));
  return options;
}

KernelSpec kernel_spec(const TraversalType& type, const OptionValues& given, Program program, Mode mode, u32 features,
                       const StructureForm& form) {
  const std::string name = std::string(type.structure) + "/" + std::string(type.traversal);
  const Kind kernel{.name = name, .help = type.help, .options = kernel_options(type), .build = nullptr};
  const OptionValues values = with_defaults(kernel, given);
  const auto value = [&](const char* option) { return static_cast<u32>(values.at(option)); };

  check_form(name, form, values);
  KernelSpec spec;
  spec.program = program;
  spec.traversal = type.type;
  const Knobs knobs = knobs_of(values);
  spec.intersector = intersector_rows()[knobs.intersector].type;
  spec.slab = slab_rows()[knobs.slab].type;
  spec.nodes = node_rows()[form.nodes].type;
  spec.stack_entries = knobs.stack_entries;
  spec.block = value("block");
  spec.registers = value("registers");
  if (spec.registers != 0 && spec.registers < kFewestRegisters) {
    throw std::invalid_argument(name + " option registers: " + std::to_string(spec.registers) + " is neither 0 nor " +
                                std::to_string(kFewestRegisters) + " to 255, which is what the assembler can do");
  }
  if (program != Program::trace) {
    spec.spawn = spawn_rows()[knobs.spawn].type;
    spec.mode = mode;
    spec.features = mode == Mode::whitted ? features : features & ~u32{kFeatureReflection | kFeatureRefraction};
  } else {
    spec.features = 0;
  }
  return spec;
}

}  // namespace raywalk::cuda
