// Validation by valijson; its context strings become RFC 6901 pointers.
#include "server/http/validator.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "server/http/problem.h"

namespace raywalk::http {
namespace {

constexpr int kMaxDepth = 32;
constexpr std::size_t kMaxOffences = 32;

std::string escaped(std::string_view token) {
  std::string out;
  for (const char c : token) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

/// valijson writes `<root>`, then `[name]` or `["name"]` for each step.
std::string pointer_of(const std::vector<std::string>& context) {
  std::string pointer;
  for (std::size_t i = 1; i < context.size(); ++i) {
    std::string_view step = context[i];
    if (step.size() >= 2 && step.front() == '[' && step.back() == ']') step = step.substr(1, step.size() - 2);
    if (step.size() >= 2 && step.front() == '"' && step.back() == '"') step = step.substr(1, step.size() - 2);
    pointer.append("/").append(escaped(step));
  }
  return pointer;
}

/// The name between the last pair of single quotes.
std::string quoted_name(std::string_view text) {
  const std::size_t end = text.rfind('\'');
  const std::size_t begin = text.find('\'', text.find(": '") == std::string_view::npos ? 0 : text.find(": '"));
  return begin < end ? std::string(text.substr(begin + 1, end - begin - 1)) : std::string();
}

/// Says again what a deeper error says better.
bool is_summary(std::string_view description) {
  return description.starts_with("Failed to validate item #") ||
         description.starts_with("Failed to validate against schema associated") ||
         description.starts_with("Failed to validate against additional properties schema") ||
         description.starts_with("Failed to validate against child schema");
}

Refusal::Offence offence_of(const valijson::ValidationResults::Error& error) {
  constexpr std::string_view kUnknown = "Object contains a property";
  std::string pointer = pointer_of(error.context);
  if (error.description.starts_with(kUnknown)) {
    const std::string name = quoted_name(error.description);
    return {pointer.append("/").append(escaped(name)), std::string("There is no field '").append(name).append("'.")};
  }
  return {pointer, error.description};
}

void make_whole_numbers_integers(Json& value) {
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (std::abs(number) < 9.0e15 && std::floor(number) == number) value = static_cast<std::int64_t>(number);
  } else if (value.is_structured()) {
    for (Json& child : value) make_whole_numbers_integers(child);
  }
}

/// `document` is what references point into.
void compile(const Json& document, const Json& schema, valijson::Schema& compiled) {
  Json root = document;
  root["allOf"] = Json::array({schema});
  const valijson::adapters::NlohmannJsonAdapter adapter(root);
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(adapter, compiled);
}

}  // namespace

struct Validator::Impl {
  Json document;
  Json schema;
  valijson::Schema compiled;

  const Json& resolve(const Json& node) const {
    const Json* at = &node;
    while (at->contains("$ref")) {
      at = &document.at(Json::json_pointer(at->at("$ref").get<std::string>().substr(1)));
    }
    return *at;
  }

  /// The alternative whose required fields are all present.
  const Json* alternative(const Json& alternatives, const Json& value) const {
    for (const Json& candidate : alternatives) {
      const Json& s = resolve(candidate);
      if (!value.is_object() || s.value("type", Json()) != "object") continue;
      const Json required = s.value("required", Json::array());
      if (std::all_of(required.begin(), required.end(),
                      [&](const Json& name) { return value.contains(name.get<std::string>()); })) {
        return &s;
      }
    }
    return nullptr;
  }

  /// The alternative that shares most fields with the value: what its sender had in mind.
  const Json& likeliest(const Json& alternatives, const Json& value) const {
    const Json* best = &alternatives.front();
    int most = -1;
    for (const Json& candidate : alternatives) {
      const Json properties = resolve(candidate).value("properties", Json::object());
      int shared = 0;
      if (value.is_object()) {
        for (const auto& [name, unused] : value.items()) shared += properties.contains(name);
      }
      if (shared > most) {
        most = shared;
        best = &candidate;
      }
    }
    return *best;
  }

  /// The schema with each anyOf replaced by its likeliest alternative, so that offences are of that one alone.
  Json narrowed(const Json& node, const Json& value) const {
    const Json& s = resolve(node);
    if (s.contains("anyOf")) return narrowed(likeliest(s.at("anyOf"), value), value);
    if (!value.is_object() || !s.contains("properties")) return s;
    Json out = s;
    for (auto& [name, property] : out["properties"].items()) {
      if (value.contains(name)) property = narrowed(property, value.at(name));
    }
    return out;
  }

  void fill(const Json& node, Json& value) const {
    const Json& s = resolve(node);
    if (s.contains("anyOf")) {
      if (const Json* chosen = alternative(s.at("anyOf"), value)) fill(*chosen, value);
    }
    if (value.is_object() && s.contains("properties")) {
      for (const auto& [name, property] : s.at("properties").items()) {
        const Json& p = resolve(property);
        if (!value.contains(name) && p.contains("default")) value[name] = p.at("default");
        if (value.contains(name)) fill(p, value[name]);
      }
    }
    if (value.is_array() && s.contains("items")) {
      for (Json& item : value) fill(s.at("items"), item);
    }
  }
};

Validator::Validator(const Json& document, const Json& schema) : impl_(std::make_unique<Impl>()) {
  impl_->document = {{"components", document.value("components", Json::object())}};
  impl_->schema = schema;
  compile(impl_->document, schema, impl_->compiled);
}

Validator::~Validator() = default;
Validator::Validator(Validator&&) noexcept = default;
Validator& Validator::operator=(Validator&&) noexcept = default;

std::vector<Refusal::Offence> Validator::check(const Json& value) const {
  thread_local valijson::Validator validator(valijson::Validator::kStrongTypes);  // keeps compiled patterns
  const valijson::adapters::NlohmannJsonAdapter adapter(value);
  if (validator.validate(impl_->compiled, adapter, nullptr)) return {};

  // Refused requests are rare: they may cost a schema of their own, for clear words.
  valijson::Schema narrowed;
  compile(impl_->document, impl_->narrowed(impl_->schema, value), narrowed);
  valijson::ValidationResults results;
  validator.validate(narrowed, adapter, &results);
  std::vector<Refusal::Offence> offences;
  std::set<std::pair<std::string, std::string>> seen;
  for (const auto& error : results) {
    if (is_summary(error.description)) continue;
    Refusal::Offence offence = offence_of(error);
    if (seen.emplace(offence.pointer, offence.detail).second) offences.push_back(std::move(offence));
    if (offences.size() == kMaxOffences) break;
  }
  if (offences.empty()) offences.push_back({"", "The value does not match its schema."});
  return offences;
}

void Validator::fill_defaults(Json& value) const {
  impl_->fill(impl_->schema, value);
}

Json parse_json(std::string_view text) {
  const auto shallow = [](int depth, Json::parse_event_t, Json&) {
    if (depth > kMaxDepth) {
      throw ApiError(400, "malformed_json", "The JSON is nested deeper than " + std::to_string(kMaxDepth) + " levels.");
    }
    return true;
  };
  try {
    Json value = Json::parse(text, shallow);
    make_whole_numbers_integers(value);
    return value;
  } catch (const Json::exception& e) {
    throw ApiError(400, "malformed_json", std::string("The body is not JSON: ") + e.what());
  }
}

}  // namespace raywalk::http
