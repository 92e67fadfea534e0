// One function a keyword; sentences begin with "must".
#include "server/http/explain.h"

#include <algorithm>
#include <cstdio>
#include <regex>

namespace raywalk::http {
namespace {

constexpr std::size_t kMaxShown = 40;  // bytes of a value that are told back

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

std::string number_text(const Json& number) {
  if (!number.is_number_float()) return number.dump();
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", number.get<double>());
  std::string out = text;
  if (const std::size_t plus = out.find("e+"); plus != std::string::npos) out.erase(plus + 1, 1);
  return out;
}

/// The value itself if it is short, else what it is.
std::string shown(const Json& value) {
  if (value.is_number()) return number_text(value);
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() <= kMaxShown) return text;
  return "a text of " + std::to_string(value.get_ref<const std::string&>().size()) + " bytes";
}

std::string listed(const std::vector<std::string>& words, const char* last) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? last : ", ";
    out += words[i];
  }
  return out;
}

std::string noun(const std::string& type) {
  if (type == "integer") return "an integer";
  if (type == "object") return "an object";
  if (type == "array") return "a list";
  if (type == "string") return "a text";
  if (type == "null") return "null";
  return "a " + type;
}

bool has_type(const Json& value, const std::string& type) {
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  return value.is_null();
}

class Explainer {
 public:
  explicit Explainer(const Json& document) : document_(document) {}

  void check(const Json& node, const Json& value, const std::string& pointer) {
    const Json& schema = resolved(document_, node);
    if (schema.contains("anyOf")) return check_alternatives(schema, value, pointer);
    if (!check_type(schema, value, pointer) || !check_choice(schema, value, pointer)) return;
    if (value.is_number()) check_number(schema, value, pointer);
    if (value.is_string()) check_text(schema, value.get_ref<const std::string&>(), pointer);
    if (value.is_array()) check_list(schema, value, pointer);
    if (value.is_object()) check_object(schema, value, pointer);
  }

  std::vector<Refusal::Offence> offences() { return std::move(offences_); }

 private:
  void offend(const std::string& pointer, std::string detail) { offences_.push_back({pointer, std::move(detail)}); }
  void must(const std::string& pointer, const std::string& what, const Json& value) {
    offend(pointer, "must " + what + "; it is " + shown(value));
  }

  void check_alternatives(const Json& schema, const Json& value, const std::string& pointer) {
    const Json& alternatives = schema.at("anyOf");
    const std::string field = discriminator(schema);
    if (field.empty() || !value.is_object() || !value.contains(field)) {
      return check(likeliest(alternatives, value), value, pointer);
    }
    if (const Json* chosen = alternative_named(document_, schema, value)) return check(*chosen, value, pointer);
    Json names = {{"enum", Json::array()}};
    for (const Json& one : alternatives) {
      for (const Json& name : resolved(document_, one).at("properties").at(field).at("enum")) {
        names["enum"].push_back(name);
      }
    }
    check_choice(names, value.at(field), pointer + "/" + escaped(field));
  }

  const Json& likeliest(const Json& alternatives, const Json& value) const {
    const Json* best = &alternatives.front();
    int most = -1;
    for (const Json& candidate : alternatives) {
      const Json properties = resolved(document_, candidate).value("properties", Json::object());
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

  bool check_type(const Json& schema, const Json& value, const std::string& pointer) {
    if (!schema.contains("type")) return true;
    const Json& type = schema.at("type");
    const auto types = type.is_array() ? type.get<std::vector<std::string>>() : std::vector<std::string>{type};
    if (std::any_of(types.begin(), types.end(), [&](const std::string& t) { return has_type(value, t); })) return true;
    std::vector<std::string> nouns;
    for (const std::string& t : types) nouns.push_back(noun(t));
    must(pointer, "be " + listed(nouns, " or "), value);
    return false;
  }

  bool check_choice(const Json& schema, const Json& value, const std::string& pointer) {
    if (!schema.contains("enum")) return true;
    const Json& choices = schema.at("enum");
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return true;
    std::vector<std::string> words;
    for (const Json& choice : choices) words.push_back(choice.is_string() ? choice.get<std::string>() : choice.dump());
    must(pointer, (words.size() == 1 ? "be " : "be one of ") + listed(words, ", "), value);
    return false;
  }

  void check_number(const Json& schema, const Json& value, const std::string& pointer) {
    if (schema.contains("minimum") && value < schema.at("minimum")) {
      must(pointer, "be at least " + number_text(schema.at("minimum")), value);
    }
    if (schema.contains("maximum") && value > schema.at("maximum")) {
      must(pointer, "be at most " + number_text(schema.at("maximum")), value);
    }
  }

  void check_text(const Json& schema, const std::string& text, const std::string& pointer) {
    if (text.size() < schema.value("minLength", std::size_t{0})) {
      return offend(pointer, text.empty() ? "must not be empty" : "is too short");
    }
    if (schema.contains("maxLength") && text.size() > schema.at("maxLength").get<std::size_t>()) {
      return must(pointer, "have at most " + schema.at("maxLength").dump() + " characters", text);
    }
    if (!schema.contains("pattern")) return;
    const std::string pattern = schema.at("pattern");
    if (!std::regex_search(text, std::regex(pattern))) must(pointer, "match " + pattern, text);
  }

  void check_list(const Json& schema, const Json& list, const std::string& pointer) {
    const std::size_t least = schema.value("minItems", std::size_t{0});
    const std::size_t most = schema.value("maxItems", list.size());
    if (list.size() < least || list.size() > most) {
      const char* bound = least == most ? "have " : list.size() < least ? "have at least " : "have at most ";
      const std::size_t count = list.size() < least ? least : most;
      must(pointer, bound + std::to_string(count) + (count == 1 ? " item" : " items"), list);
    }
    if (schema.value("uniqueItems", false)) {
      for (auto item = list.begin(); item != list.end(); ++item) {
        if (std::find(list.begin(), item, *item) == item) continue;
        offend(pointer, "must not hold " + shown(*item) + " twice");
        break;
      }
    }
    if (!schema.contains("items")) return;
    for (std::size_t i = 0; i < list.size(); ++i) {
      check(schema.at("items"), list[i], std::string(pointer).append("/").append(std::to_string(i)));
    }
  }

  void check_object(const Json& schema, const Json& object, const std::string& pointer) {
    for (const Json& name : schema.value("required", Json::array())) {
      const std::string field = name;
      if (!object.contains(field)) offend(pointer, "must have the field '" + field + "'");
    }
    const Json properties = schema.value("properties", Json::object());
    const Json others = schema.value("additionalProperties", Json(true));
    for (const auto& [name, member] : object.items()) {
      const std::string at = std::string(pointer).append("/").append(escaped(name));
      if (properties.contains(name)) {
        check(properties.at(name), member, at);
      } else if (others.is_object()) {
        check(others, member, at);
      } else if (others == false) {
        std::vector<std::string> known;
        for (const auto& [property, unused] : properties.items()) known.push_back(property);
        const std::string fields = known.empty() ? "there are none" : "the fields are " + listed(known, ", ");
        offend(at, "there is no field '" + name + "'; " + fields);
      }
    }
  }

  const Json& document_;
  std::vector<Refusal::Offence> offences_;
};

}  // namespace

const Json& resolved(const Json& document, const Json& node) {
  const Json* at = &node;
  while (at->contains("$ref")) at = &document.at(Json::json_pointer(at->at("$ref").get<std::string>().substr(1)));
  return *at;
}

std::string discriminator(const Json& schema) {
  return schema.value("discriminator", Json::object()).value("propertyName", "");
}

const Json* alternative_named(const Json& document, const Json& schema, const Json& value) {
  const std::string field = discriminator(schema);
  if (field.empty() || !value.is_object() || !value.contains(field)) return nullptr;
  for (const Json& candidate : schema.at("anyOf")) {
    const Json& names = resolved(document, candidate).at("properties").at(field).at("enum");
    if (std::find(names.begin(), names.end(), value.at(field)) != names.end()) return &candidate;
  }
  return nullptr;
}

std::vector<Refusal::Offence> explain(const Json& document, const Json& schema, const Json& value) {
  Explainer explainer(document);
  explainer.check(schema, value, "");
  return explainer.offences();
}

}  // namespace raywalk::http
