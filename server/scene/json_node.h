// A JSON value that knows its file and its place, so that every complaint names both.
#pragma once
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "kernels/vec.h"

namespace raywalk {

/// All throw std::runtime_error "<file>: <JSON pointer>: <what is wrong>".
class JsonNode {
 public:
  JsonNode(const nlohmann::json& value, std::string file, std::string pointer = "")
      : value_(&value), file_(std::move(file)), pointer_(std::move(pointer)) {}

  /// Member of an object that must be there.
  JsonNode at(const char* key) const;
  std::optional<JsonNode> find(const char* key) const;
  /// Items of an array of at least `least` values.
  std::vector<JsonNode> items(size_t least) const;
  /// The value must be an object without other keys.
  void allow_only(std::initializer_list<const char*> keys) const;

  std::string text() const;
  u64 count(u64 least, u64 most) const;
  float number(float least, float most) const;
  /// Three numbers, each in the range.
  Vec3 vector(float least, float most) const;
  bool is_null() const { return value_->is_null(); }
  bool is_text() const { return value_->is_string(); }
  std::string dump() const { return value_->dump(); }

  [[noreturn]] void fail(const std::string& message) const;

 private:
  JsonNode child(const nlohmann::json& value, const std::string& key) const {
    return JsonNode(value, file_, pointer_ + "/" + key);
  }

  const nlohmann::json* value_;
  std::string file_;
  std::string pointer_;
};

}  // namespace raywalk
