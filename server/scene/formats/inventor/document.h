// An Open Inventor file as it was written: nodes with fields and children. USE is an edge to a node that came before,
// so that the nodes form a graph without cycles.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/platform.h"

namespace raywalk {

constexpr u32 kNoNode = 0xffffffffu;

/// The value of a field is kept as what it is made of: numbers, words (names, strings without their quotes) or a node.
struct IvField {
  std::string_view name;
  u32 line = 0;
  bool ignored = false;  // "~": the field changes nothing
  u32 node = kNoNode;
  std::vector<double> numbers;
  std::vector<std::string_view> words;
};

struct IvNode {
  std::string_view type;
  std::string_view name;  // by DEF; empty if it has none
  u32 line = 0;
  std::vector<IvField> fields;
  std::vector<u32> children;
};

/// Owns the text that its nodes point into: not to be copied or moved.
struct IvDocument {
  IvDocument() = default;
  IvDocument(const IvDocument&) = delete;
  IvDocument& operator=(const IvDocument&) = delete;

  std::filesystem::path file;
  std::string text;
  std::vector<IvNode> nodes;
  std::vector<u32> roots;
};

/// Takes the text of a file apart. Throws std::runtime_error naming file and line if it is not ascii Inventor 1.0 or
/// 2.x or VRML 1.0, braces do not match, a node is used before it is defined, numbers are not finite, nodes are nested
/// too deep or there are too many.
std::unique_ptr<const IvDocument> parse_inventor(const std::filesystem::path& file, std::string text);

/// Whether this is a type of node that is read; others are skipped.
bool is_known_inventor_node(std::string_view type);

}  // namespace raywalk
