// Checked access to values.
#include "server/scene/formats/inventor/fields.h"

#include <charconv>
#include <cmath>

#include "server/scene/scene_builder.h"
#include "server/scene/text.h"

namespace raywalk {

std::string decimal(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

std::string IvFields::place() const {
  return at_line(document_.file, node_.line);
}

const IvField* IvFields::with_name(std::string_view name) const {
  for (const IvField& field : node_.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

const IvField* IvFields::find(std::string_view name) const {
  const IvField* field = with_name(name);
  return field != nullptr && !field->ignored ? field : nullptr;
}

bool IvFields::ignored(std::string_view name) const {
  const IvField* field = with_name(name);
  return field != nullptr && field->ignored;
}

void IvFields::fail(std::string_view name, const std::string& what) const {
  const IvField* field = with_name(name);
  throw PlacedError(at_line(document_.file, field != nullptr ? field->line : node_.line) + ": " +
                    std::string(node_.type) + "." + std::string(name) + ": " + what);
}

std::span<const double> IvFields::list(std::string_view name, u32 group) const {
  const IvField* field = find(name);
  if (field == nullptr) return {};
  if (!field->words.empty()) fail(name, in_quotes(field->words[0]) + " is not a number");
  if (field->numbers.size() % group != 0) {
    fail(name, std::to_string(field->numbers.size()) + " numbers are not a multiple of " + std::to_string(group));
  }
  return field->numbers;
}

std::span<const double> IvFields::exactly(std::string_view name, size_t count) const {
  const std::span<const double> numbers = list(name, 1);
  if (!numbers.empty() && numbers.size() != count) {
    fail(name, std::to_string(numbers.size()) + " numbers where " + std::to_string(count) + " were expected");
  }
  return numbers;
}

double IvFields::number(std::string_view name, double otherwise) const {
  const std::span<const double> numbers = exactly(name, 1);
  return numbers.empty() ? otherwise : numbers[0];
}

glm::dvec3 IvFields::vector(std::string_view name, glm::dvec3 otherwise) const {
  const std::span<const double> n = exactly(name, 3);
  return n.empty() ? otherwise : glm::dvec3{n[0], n[1], n[2]};
}

glm::dvec4 IvFields::rotation(std::string_view name) const {
  const std::span<const double> n = exactly(name, 4);
  return n.empty() ? glm::dvec4{0, 0, 1, 0} : glm::dvec4{n[0], n[1], n[2], n[3]};
}

int IvFields::integer(std::string_view name, int otherwise) const {
  const double value = number(name, otherwise);
  if (value != std::trunc(value) || std::abs(value) > 2e9) fail(name, "an integer was expected");
  return static_cast<int>(value);
}

bool IvFields::flag(std::string_view name, bool otherwise) const {
  const IvField* field = find(name);
  if (field == nullptr) return otherwise;
  if (!field->words.empty()) return field->words[0] == "TRUE";
  return number(name, otherwise) != 0.0;
}

std::string_view IvFields::word(std::string_view name) const {
  const IvField* field = find(name);
  return field != nullptr && !field->words.empty() ? field->words[0] : std::string_view();
}

std::string IvFields::string(std::string_view name) const {
  std::string plain;
  const std::string_view written = word(name);
  for (size_t i = 0; i < written.size(); ++i) {
    if (written[i] == '\\' && i + 1 < written.size()) ++i;
    plain += written[i];
  }
  return plain;
}

}  // namespace raywalk
