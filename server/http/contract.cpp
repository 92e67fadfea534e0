// Reads the operations of the OpenAPI document.
#include "server/http/contract.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "server/http/explain.h"
#include "server/http/parse_json.h"
#include "server/http/problem.h"

namespace raywalk::http {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

struct ParameterSet {
  std::vector<Parameter> names;
  Json schema = {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};

  void add(const Json& document, const Json& parameter) {
    const std::string name = parameter.at("name");
    const Json& type = resolved(document, parameter.at("schema"));
    const bool required = parameter.value("required", false);
    names.push_back({name, type.value("type", "") == "integer" || type.value("type", "") == "number", required});
    schema["properties"][name] = parameter.at("schema");
    if (required) schema["required"].push_back(name);
  }
};

void read_parameters(const Json& document, const Json& path_item, const Json& operation, Operation& out) {
  std::map<std::string, ParameterSet> sets;
  for (const Json* owner : {&path_item, &operation}) {
    for (const Json& node : owner->value("parameters", Json::array())) {
      const Json& parameter = resolved(document, node);
      const std::string name = parameter.at("name");
      if (name != "Accept") sets[parameter.at("in")].add(document, parameter);  // Accept is negotiated, not validated
    }
  }
  if (sets.contains("path")) out.path_check.emplace(document, sets["path"].schema);
  if (sets.contains("header")) {
    out.header_check.emplace(document, sets["header"].schema);
    out.headers = sets["header"].names;
  }
  out.query_check.emplace(document, sets["query"].schema);
  out.query = sets["query"].names;
}

void read_body(const Json& document, const Json& operation, Operation& out) {
  if (!operation.contains("requestBody")) return;
  const auto& [media_type, content] = *operation.at("requestBody").at("content").items().begin();
  out.media_type = media_type;
  if (media_type == "application/json") {
    out.body = BodyKind::json;
    out.body_check.emplace(document, content.at("schema"));
  } else {
    out.body = out.method == "PUT" ? BodyKind::file : BodyKind::bytes;
  }
}

Json typed(const Parameter& parameter, const std::string& text) {
  if (!parameter.is_number) return text;
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return text;
  if (std::floor(number) == number && std::abs(number) < 9.0e15) return static_cast<std::int64_t>(number);
  return number;
}

[[noreturn]] void refuse_parameters(const std::string& where, std::vector<Refusal::Offence> offences) {
  for (Refusal::Offence& o : offences) {
    const std::string name = o.pointer.empty() ? "" : o.pointer.substr(1);
    o.pointer = "?" + name;
  }
  const std::string detail = "The " + where + " parameter '" + offences.front().pointer.substr(1) +
                             "' is not as the contract says: " + offences.front().detail + ".";
  throw ApiError(400, "invalid_parameter", detail, std::move(offences));
}

}  // namespace

Contract::Contract(std::string_view openapi_json) : text_(openapi_json), document_(Json::parse(openapi_json)) {
  for (const auto& [pattern, path_item] : document_.at("paths").items()) {
    for (const auto& [method, node] : path_item.items()) {
      if (method == "parameters") continue;
      Operation operation;
      operation.id = node.at("operationId");
      operation.method = upper(method);
      operation.pattern = pattern;
      read_parameters(document_, path_item, node, operation);
      read_body(document_, node, operation);
      if (const Json& responses = node.at("responses"); responses.contains("200")) {
        const Json content = resolved(document_, responses.at("200")).value("content", Json::object());
        for (const auto& [type, unused] : content.items()) operation.answers.push_back(type);
      }
      operations_.push_back(std::move(operation));
    }
  }
}

Validator Contract::schema(const std::string& name) const {
  return Validator(document_, {{"$ref", "#/components/schemas/" + name}});
}

void check_path(const Operation& operation, const std::map<std::string, std::string>& given) {
  if (!operation.path_check) return;
  if (auto offences = operation.path_check->check(Json(given)); !offences.empty()) refuse_parameters("path", offences);
}

Json check_query(const Operation& operation, const std::multimap<std::string, std::string>& given) {
  Json query = Json::object();
  for (const auto& [name, text] : given) {
    if (query.contains(name)) refuse_parameters("query", {{"/" + name, "must not be given more than once"}});
    const auto known = std::find_if(operation.query.begin(), operation.query.end(),
                                    [&name = name](const Parameter& p) { return p.name == name; });
    query[name] = known == operation.query.end() ? Json(text) : typed(*known, text);
  }
  if (auto offences = operation.query_check->check(query); !offences.empty()) {
    for (const Parameter& p : operation.query) {
      if (p.required && !query.contains(p.name)) offences.push_back({"/" + p.name, "must be given"});
    }
    if (!offences.back().pointer.empty()) {  // then those of the query as a whole, which has no name, are said
      std::erase_if(offences, [](const Refusal::Offence& o) { return o.pointer.empty(); });
    }
    refuse_parameters("query", offences);
  }
  operation.query_check->fill_defaults(query);
  return query;
}

void check_headers(const Operation& operation, const std::map<std::string, std::string>& given) {
  if (!operation.header_check) return;
  Json headers = Json::object();
  for (const Parameter& p : operation.headers) {
    if (const auto found = given.find(lower(p.name)); found != given.end()) headers[p.name] = typed(p, found->second);
  }
  if (auto offences = operation.header_check->check(headers); !offences.empty()) refuse_parameters("header", offences);
}

Json check_body(const Operation& operation, std::string_view text) {
  Json body = parse_json(text);
  if (auto offences = operation.body_check->check(body); !offences.empty()) {
    const std::string detail =
        "The body is not as the contract says at '" + offences.front().pointer + "': " + offences.front().detail + ".";
    throw ApiError(422, "invalid_request", detail, std::move(offences));
  }
  operation.body_check->fill_defaults(body);
  return body;
}

}  // namespace raywalk::http
