// Options by name: ranges, choices, ids.
#include "server/catalog/build_options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "kernels/accel/build_records.h"
#include "server/device/knobs.h"
#include "server/system/refusal.h"

namespace raywalk {
namespace {

template <class Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.emplace_back(item.name);
  return names;
}

std::string brief(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

[[noreturn]] void refuse(const Option& option, const std::string& pointer, const std::string& why) {
  const std::string name(option.name);
  throw Refusal(Refusal::Why::invalid, "invalid_option", "Option '" + name + "' " + why).at(pointer + "/" + name);
}

double choice_index(const Option& option, const std::string& value, const std::string& pointer) {
  const auto found = std::find(option.choices.begin(), option.choices.end(), value);
  if (found == option.choices.end()) {
    std::string all;
    for (const std::string_view choice : option.choices) all += (all.empty() ? "" : ", ") + std::string(choice);
    refuse(option, pointer, all.empty() ? "is a number." : "is one of " + all + ".");
  }
  return static_cast<double>(found - option.choices.begin());
}

double number(const Option& option, double value, const std::string& pointer) {
  if (!option.choices.empty()) refuse(option, pointer, "takes the name of a choice, not a number.");
  if (!(value >= option.min && value <= option.max)) {
    refuse(option, pointer, "is from " + brief(option.min) + " to " + brief(option.max) + ".");
  }
  if (option.integer && std::floor(value) != value) refuse(option, pointer, "is a whole number.");
  if (option.step > 0 && std::fmod(value, option.step) != 0) {
    refuse(option, pointer, "is a multiple of " + brief(option.step) + ".");
  }
  return value;
}

}  // namespace

const KindInfo& kind_named(const std::vector<KindInfo>& kinds, const std::string& name, const std::string& pointer) {
  for (const KindInfo& kind : kinds) {
    if (kind.name == name) return kind;
  }
  throw Refusal(Refusal::Why::unknown, "unknown_kind", "There is no structure kind '" + name + "'.")
      .at(pointer)
      .known(names_of(kinds));
}

const TraversalInfo& traversal_named(const KindInfo& kind, const std::string& name, const std::string& pointer) {
  for (const TraversalInfo& traversal : kind.traversals) {
    if (traversal.name == name) return traversal;
  }
  throw Refusal(Refusal::Why::unknown, "unknown_traversal", "'" + kind.name + "' has no traversal '" + name + "'.")
      .at(pointer)
      .known(names_of(kind.traversals));
}

OptionValues complete_options(const std::vector<Option>& known, const std::string& owner, const GivenOptions& given,
                              const std::string& pointer) {
  OptionValues options;
  for (const Option& option : known) {
    const std::string name(option.name);
    const auto found = given.find(name);
    if (found == given.end()) {
      options[name] = option.default_value;
    } else if (const auto* choice = std::get_if<std::string>(&found->second)) {
      options[name] = choice_index(option, *choice, pointer);
    } else {
      options[name] = number(option, std::get<double>(found->second), pointer);
    }
  }
  for (const auto& [name, unused] : given) {
    if (!options.contains(name)) {
      throw Refusal(Refusal::Why::invalid, "unknown_option", "'" + owner + "' has no option '" + name + "'.")
          .at(pointer + "/" + name)
          .known(names_of(known));
    }
  }
  return options;
}

OptionValues complete_options(const KindInfo& kind, const GivenOptions& given, const std::string& pointer) {
  return complete_options(kind.options, kind.name, given, pointer);
}

OptionValues complete_options(const KindInfo& kind, const TraversalInfo& traversal, const GivenOptions& given,
                              const std::string& pointer) {
  return complete_options(traversal.options, kind.name + "/" + traversal.name, given, pointer);
}

StructureForm form_of(const OptionValues& options) {
  StructureForm form;
  if (options.contains("triangles")) form.triangles = triangles_of(options);
  if (const auto nodes = options.find("nodes"); nodes != options.end()) form.nodes = static_cast<u32>(nodes->second);
  return form;
}

void check_form(const StructureForm& form, const OptionValues& kernel, const std::string& pointer) {
  const std::string why = why_unfit(form, kernel);
  if (!why.empty()) throw Refusal(Refusal::Why::invalid, "unfit_structure", why).at(pointer);
}

GivenOption shown_option(const Option& option, double value) {
  if (option.choices.empty()) return value;
  return std::string(option.choices.at(static_cast<std::size_t>(value)));
}

std::string changed_options(const std::vector<Option>& options, const OptionValues& values) {
  std::ostringstream text;
  for (const Option& option : options) {
    const double value = values.find(option.name)->second;
    if (value == option.default_value) continue;
    text << ' ' << option.name << '=';
    std::visit([&](const auto& shown) { text << shown; }, shown_option(option, value));
  }
  return text.str();
}

std::string structure_id(const std::string& scene, const KindInfo& kind, const OptionValues& options) {
  u32 hash = 2166136261u;  // FNV-1a
  bool all_default = true;
  for (const Option& option : kind.options) {
    const double value = options.find(option.name)->second;
    all_default = all_default && value == option.default_value;
    for (const char c : std::string(option.name) + "=" + brief(value) + ";") {
      hash = (hash ^ static_cast<u8>(c)) * 16777619u;
    }
  }
  std::string id = scene + "." + kind.name;
  if (!all_default) {
    char text[16];
    std::snprintf(text, sizeof text, ".%08x", hash);
    id += text;
  }
  return id;
}

}  // namespace raywalk
