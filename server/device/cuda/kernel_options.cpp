// The options' ranges and defaults, and what they mean for the compiler.
#include "server/device/cuda/kernel_options.h"

#include <algorithm>
#include <array>

namespace raywalk::cuda {
namespace {

/// What a traversal runs best with.
struct Tuning {
  std::string_view type;
  u32 block, registers, stack_entries;
};
constexpr Tuning kPlain{"", 128, 0, 4};
constexpr std::array kTunings = {
    Tuning{"Brute", 128, 0, 4},
    Tuning{"GridDda", 128, 0, 4},
    Tuning{"KdtreeShortStack3", 128, 0, 4},
    Tuning{"KdtreeShortStack2", 128, 0, 4},
    Tuning{"BvhPacket", 64, 0, 4},
    Tuning{"BvhWhileWhile", 128, 0, 4},
};

/// Ray-triangle tests: their names on the wire, and the types that kernels know them by.
struct Intersector {
  std::string_view name, type;
};
constexpr std::array kIntersectors = {Intersector{"watertight", "Watertight"}};

constexpr u32 kWarp = 32, kMaxBlock = 512;

const Tuning& tuning_of(const TraversalType& type) {
  const auto found =
      std::find_if(kTunings.begin(), kTunings.end(), [&](const Tuning& t) { return t.type == type.type; });
  return found == kTunings.end() ? kPlain : *found;
}

bool has_short_stack(const TraversalType& type) {
  return type.traversal.starts_with("short-stack");
}

}  // namespace

const TraversalType& traversal_type(const std::string& structure, const std::string& traversal) {
  for (const TraversalType& type : traversal_types())
    if (type.structure == structure && type.traversal == traversal) return type;
  throw std::invalid_argument(structure + " has no traversal " + traversal);
}

std::vector<Option> kernel_options(const TraversalType& type) {
  const Tuning& tuning = tuning_of(type);
  std::vector<Option> options = {{.name = "registers",
                                  .help = "most registers a thread; 0 leaves it to the compiler",
                                  .default_value = static_cast<double>(tuning.registers),
                                  .max = 255,
                                  .integer = true}};
  if (type.group <= kWarp) {
    options.push_back({.name = "block",
                       .help = "threads a block, a multiple of 32",
                       .default_value = static_cast<double>(tuning.block),
                       .min = kWarp,
                       .max = kMaxBlock,
                       .integer = true});
  }
  if (has_short_stack(type)) {
    options.push_back({.name = "stack_entries",
                       .help = "entries of the short stack",
                       .default_value = static_cast<double>(tuning.stack_entries),
                       .min = 1,
                       .max = 16,
                       .integer = true});
  }
  Option intersector{.name = "intersector", .help = "ray-triangle test", .integer = true};
  for (const Intersector& row : kIntersectors) intersector.choices.push_back(row.name);
  options.push_back(std::move(intersector));
  return options;
}

KernelSpec kernel_spec(const TraversalType& type, const OptionValues& given, Program program, Mode mode, u32 features) {
  const std::string name = std::string(type.structure) + "/" + std::string(type.traversal);
  const Kind kernel{.name = name, .help = type.help, .options = kernel_options(type), .build = nullptr};
  const OptionValues values = with_defaults(kernel, given);
  const auto value = [&](const char* option, u32 otherwise) {
    const auto found = values.find(option);
    return found == values.end() ? otherwise : static_cast<u32>(found->second);
  };

  KernelSpec spec;
  spec.program = program;
  spec.traversal = type.type;
  spec.intersector = kIntersectors[value("intersector", 0)].type;
  spec.block = value("block", type.group);
  if (spec.block % kWarp != 0)
    throw std::invalid_argument(name + " option block: " + std::to_string(spec.block) + " is not a multiple of 32");
  spec.registers = value("registers", 0);
  spec.stack_entries = value("stack_entries", kPlain.stack_entries);
  if (program != Program::trace) {
    spec.mode = mode;
    spec.features = mode == Mode::whitted ? features : features & ~u32{kFeatureReflection | kFeatureRefraction};
  } else {
    spec.features = 0;
  }
  return spec;
}

}  // namespace raywalk::cuda
