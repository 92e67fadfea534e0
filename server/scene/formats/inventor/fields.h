// The fields of one node, with defaults and checks.
#pragma once
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <stdexcept>

#include "server/scene/formats/inventor/document.h"

namespace raywalk {

/// An error whose text begins with file and line.
class PlacedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// As short as it can be written.
std::string decimal(double value);

/// Every access throws PlacedError if the field has another kind of value. A field with "~" counts as not there.
class IvFields {
 public:
  IvFields(const IvDocument& document, const IvNode& node) : document_(document), node_(node) {}

  const IvDocument& document() const { return document_; }
  const IvNode& node() const { return node_; }
  /// File and line of the node.
  std::string place() const;

  const IvField* find(std::string_view name) const;
  /// Whether the file forbids the field to change anything.
  bool ignored(std::string_view name) const;
  double number(std::string_view name, double otherwise) const;
  glm::dvec3 vector(std::string_view name, glm::dvec3 otherwise) const;
  /// Axis and angle.
  glm::dvec4 rotation(std::string_view name) const;
  int integer(std::string_view name, int otherwise) const;
  bool flag(std::string_view name, bool otherwise) const;
  /// The first word; empty if there is none.
  std::string_view word(std::string_view name) const;
  /// A string without its escapes; empty if there is none.
  std::string string(std::string_view name) const;
  /// Groups of `group` numbers; empty if the field is not there.
  std::span<const double> list(std::string_view name, u32 group) const;
  /// Throws an error at the field's line.
  [[noreturn]] void fail(std::string_view name, const std::string& what) const;

 private:
  const IvField* with_name(std::string_view name) const;
  std::span<const double> exactly(std::string_view name, size_t count) const;

  const IvDocument& document_;
  const IvNode& node_;
};

}  // namespace raywalk
