// valijson decides; explain() gives the reasons.
#include "server/http/validator.h"

#include <algorithm>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "server/http/explain.h"

namespace raywalk::http {
namespace {

constexpr std::size_t kMaxOffences = 32;

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

  const Json& resolve(const Json& node) const { return resolved(document, node); }

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

  void fill(const Json& node, Json& value) const {
    const Json& s = resolve(node);
    if (s.contains("anyOf")) {
      const Json* named = alternative_named(document, s, value);
      if (const Json* chosen = named != nullptr ? named : alternative(s.at("anyOf"), value)) fill(*chosen, value);
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

  std::vector<Refusal::Offence> offences = explain(impl_->document, impl_->schema, value);
  if (offences.empty()) offences.push_back({"", "does not match its schema"});
  if (offences.size() > kMaxOffences) offences.resize(kMaxOffences);
  return offences;
}

void Validator::fill_defaults(Json& value) const {
  impl_->fill(impl_->schema, value);
}

}  // namespace raywalk::http
