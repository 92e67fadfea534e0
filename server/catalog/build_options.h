// Options of builders and kernels as a request gives them, and the structure ids that follow from them.
#pragma once
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "server/device/device.h"

namespace raywalk {

/// A number, or the name of a choice.
using GivenOption = std::variant<double, std::string>;
using GivenOptions = std::map<std::string, GivenOption>;

/// Throws Refusal unknown_kind; `pointer` is where the request names the kind.
const KindInfo& kind_named(const std::vector<KindInfo>& kinds, const std::string& name, const std::string& pointer);
/// Throws Refusal unknown_traversal.
const TraversalInfo& traversal_named(const KindInfo& kind, const std::string& name, const std::string& pointer);

/// A value for each of `options`: its default, or what is `given`. `owner` is whose options they are, for people.
/// Throws Refusal invalid_option or unknown_option with a pointer under `pointer`.
OptionValues complete_options(const std::vector<Option>& options, const std::string& owner, const GivenOptions& given,
                              const std::string& pointer);
/// Of a builder.
OptionValues complete_options(const KindInfo& kind, const GivenOptions& given, const std::string& pointer);
/// Of a traversal's kernel; `kind` has the traversal.
OptionValues complete_options(const KindInfo& kind, const TraversalInfo& traversal, const GivenOptions& given,
                              const std::string& pointer);

/// The form of a structure that is built with these complete options.
StructureForm form_of(const OptionValues& options);
/// Throws Refusal unfit_structure at `pointer` when a traversal with these kernel options cannot use that form.
void check_form(const StructureForm& form, const OptionValues& kernel, const std::string& pointer);

/// The option as a request would give it.
GivenOption shown_option(const Option& option, double value);
/// Those of the complete `values` that are not the default, as " name=value" each; empty when there are none.
std::string changed_options(const std::vector<Option>& options, const OptionValues& values);

/// `<scene>.<kind>` for default options, else `<scene>.<kind>.<8 hex digits of the options>`.
std::string structure_id(const std::string& scene, const KindInfo& kind, const OptionValues& options);

}  // namespace raywalk
