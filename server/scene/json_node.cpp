// Checked access to JSON values.
#include "server/scene/json_node.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace raywalk {
namespace {

std::string range(double least, double most) {
  std::ostringstream text;
  text << "must be a number from " << least << " to " << most;
  return text.str();
}

}  // namespace

void JsonNode::fail(const std::string& message) const {
  throw std::runtime_error(file_ + ": " + (pointer_.empty() ? "/" : pointer_) + ": " + message);
}

std::optional<JsonNode> JsonNode::find(const char* key) const {
  if (!value_->is_object()) fail("must be an object");
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return child(*found, key);
}

JsonNode JsonNode::at(const char* key) const {
  std::optional<JsonNode> member = find(key);
  if (!member) fail(std::string("'") + key + "' is missing");
  return *member;
}

std::vector<JsonNode> JsonNode::items(size_t least) const {
  if (!value_->is_array()) fail("must be an array");
  if (value_->size() < least) fail("must have at least " + std::to_string(least) + (least == 1 ? " item" : " items"));
  std::vector<JsonNode> nodes;
  for (size_t i = 0; i < value_->size(); ++i) nodes.push_back(child((*value_)[i], std::to_string(i)));
  return nodes;
}

void JsonNode::allow_only(std::initializer_list<const char*> keys) const {
  if (!value_->is_object()) fail("must be an object");
  for (const auto& member : value_->items()) {
    const bool known = std::any_of(keys.begin(), keys.end(), [&](const char* key) { return member.key() == key; });
    if (!known) child(member.value(), member.key()).fail("unknown key");
  }
}

std::string JsonNode::text() const {
  if (!value_->is_string() || value_->get_ref<const std::string&>().empty()) fail("must be a string that is not empty");
  return value_->get<std::string>();
}

u64 JsonNode::count(u64 least, u64 most) const {
  if (!value_->is_number_unsigned() || value_->get<u64>() < least || value_->get<u64>() > most) {
    fail("must be an integer from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value_->get<u64>();
}

float JsonNode::number(float least, float most) const {
  if (!value_->is_number()) fail(range(least, most));
  const double number = value_->get<double>();
  if (!(number >= least && number <= most)) fail(range(least, most));
  return static_cast<float>(number);
}

Vec3 JsonNode::vector(float least, float most) const {
  const std::vector<JsonNode> parts = items(3);
  if (parts.size() != 3) fail("must have three numbers");
  return {parts[0].number(least, most), parts[1].number(least, most), parts[2].number(least, most)};
}

}  // namespace raywalk
