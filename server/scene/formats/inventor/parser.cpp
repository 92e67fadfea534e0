// The grammar of Open Inventor files. It needs no list of fields: what follows a name tells a field from a node.
#include <cmath>
#include <map>
#include <stdexcept>

#include "server/scene/formats/inventor/document.h"
#include "server/scene/formats/inventor/lexer.h"
#include "server/scene/scene_builder.h"
#include "server/scene/text.h"

namespace raywalk {
namespace {

constexpr u32 kMostNested = 200;
constexpr size_t kMostFields = 64;  // of a node: no known one has more than twenty, and they are searched at each USE
// Of numbers and words in one document; a node or a field counts as kNodeCost of them. About 2 GiB.
constexpr u64 kMostValues = 200'000'000;
constexpr u64 kNodeCost = 16;

class IvParser {
 public:
  IvParser(IvDocument& document) : document_(document), lexer_(document.text) {}

  void parse() {
    while (lexer_.peek().kind != IvTokenKind::kEnd) {
      const IvToken& token = lexer_.peek();
      if (token.kind != IvTokenKind::kWord) fail(token, "a node was expected, not " + in_quotes(token.text));
      document_.roots.push_back(node(lexer_.take(), 0));
    }
  }

 private:
  [[noreturn]] void fail(const IvToken& at, const std::string& what) const {
    throw std::runtime_error(at_line(document_.file, at.line) + ": " + what);
  }
  void spend(u64 cost) {
    if (cost > values_left_) fail(lexer_.peek(), "more than " + std::to_string(kMostValues) + " values");
    values_left_ -= cost;
  }
  IvToken word(const char* what) {
    const IvToken token = lexer_.take();
    if (token.kind != IvTokenKind::kWord) fail(token, std::string(what) + " was expected");
    return token;
  }

  /// A node from its first word on: DEF, USE or the type.
  u32 node(const IvToken& first, u32 depth) {
    if (first.text == "USE") {
      const IvToken name = word("a name");
      const auto defined = defined_.find(name.text);
      if (defined == defined_.end()) fail(name, "USE of " + in_quotes(name.text) + ", which is not defined before");
      return defined->second;
    }
    if (first.text != "DEF") return body(first, {}, depth);
    const IvToken name = word("a name");
    const u32 made = body(word("a node"), name.text, depth);
    defined_[name.text] = made;
    return made;
  }

  u32 body(const IvToken& type, std::string_view name, u32 depth) {
    if (depth == kMostNested) fail(type, "nodes are nested more than " + std::to_string(kMostNested) + " deep");
    const IvToken brace = lexer_.take();
    if (!brace.is('{')) fail(brace, "'{' was expected after " + in_quotes(type.text));
    spend(kNodeCost);
    IvNode made{type.text, name, type.line, {}, {}};
    if (is_known_inventor_node(type.text)) {
      while (!lexer_.peek().is('}')) member(made, depth);
      lexer_.take();
    } else {
      skip_body(type);
    }
    document_.nodes.push_back(std::move(made));
    return static_cast<u32>(document_.nodes.size() - 1);
  }

  /// To the brace that closes an unknown node. Names defined inside stand for nothing from then on.
  void skip_body(const IvToken& type) {
    for (u64 open = 1; open > 0;) {
      const IvToken token = lexer_.take();
      if (token.kind == IvTokenKind::kEnd) fail(type, "the '{' of " + in_quotes(type.text) + " is never closed");
      if (token.is('{')) ++open;
      if (token.is('}')) --open;
      if (!token.is_word("DEF") || lexer_.peek().kind != IvTokenKind::kWord) continue;
      spend(kNodeCost);
      document_.nodes.push_back({"Info", {}, token.line, {}, {}});
      defined_[lexer_.peek().text] = static_cast<u32>(document_.nodes.size() - 1);
    }
  }

  void member(IvNode& parent, u32 depth) {
    const IvToken first = lexer_.take();
    if (first.kind == IvTokenKind::kEnd) {
      throw std::runtime_error(at_line(document_.file, parent.line) + ": the '{' of " + in_quotes(parent.type) +
                               " is never closed");
    }
    if (first.kind != IvTokenKind::kWord) {
      fail(first, "a field or node of " + in_quotes(parent.type) + " was expected, not " + in_quotes(first.text));
    }
    if (first.text == "DEF" || first.text == "USE" || lexer_.peek().is('{')) {
      const u32 child = node(first, depth + 1);
      spend(1);
      parent.children.push_back(child);
    } else {
      if (parent.fields.size() == kMostFields) {
        fail(first, in_quotes(parent.type) + " has more than " + std::to_string(kMostFields) + " fields");
      }
      spend(kNodeCost);
      IvField field{first.text, first.line, false, kNoNode, {}, {}};
      value(field, depth);
      parent.fields.push_back(std::move(field));
    }
  }

  void value(IvField& field, u32 depth) {
    const IvToken first = lexer_.peek();
    if (first.is('[') || first.is('(')) {
      list(field, first.is('[') ? ']' : ')');
    } else if (first.kind == IvTokenKind::kString) {
      field.words.push_back(lexer_.take().text);
    } else if (first.kind == IvTokenKind::kWord) {
      if (scalar(field, lexer_.take())) {
        double unused = 0.0;
        while (lexer_.peek().kind == IvTokenKind::kWord && is_number(lexer_.peek(), unused)) {
          scalar(field, lexer_.take());
        }
      } else if (first.text == "DEF" || first.text == "USE" || lexer_.peek().is('{')) {
        field.words.clear();
        field.node = node(first, depth + 1);
      }
    } else if (!first.is('~') && !first.is('=')) {
      fail(first, "a value of " + in_quotes(field.name) + " was expected");
    }
    if (lexer_.peek().is('~')) {
      lexer_.take();
      field.ignored = true;
    }
    if (lexer_.peek().is('=')) connection(depth);
  }

  void list(IvField& field, char closing) {
    const IvToken opening = lexer_.take();
    while (!lexer_.peek().is(closing)) {
      const IvToken token = lexer_.take();
      if (token.kind == IvTokenKind::kEnd) fail(opening, "the list of " + in_quotes(field.name) + " is never closed");
      if (token.kind == IvTokenKind::kWord) {
        scalar(field, token);
      } else if (token.kind == IvTokenKind::kString) {
        spend(2);
        field.words.push_back(token.text);
      } else if (!token.is('|')) {
        fail(token, in_quotes(token.text) + " in the list of " + in_quotes(field.name));
      }
    }
    lexer_.take();
  }

  /// "= node . output": the value comes from an engine, which stands still here.
  void connection(u32 depth) {
    lexer_.take();
    node(word("a node"), depth + 1);
    while (lexer_.peek().kind == IvTokenKind::kWord && lexer_.peek().text.starts_with('.')) {
      if (lexer_.take().text == ".") word("the name of an output");
    }
  }

  /// Adds the word to the field; true if it is a number.
  bool scalar(IvField& field, const IvToken& token) {
    double number = 0.0;
    const bool numeric = is_number(token, number);
    spend(numeric ? 1 : 2);
    if (numeric) {
      field.numbers.push_back(number);
    } else {
      field.words.push_back(token.text);
    }
    return numeric;
  }

  bool is_number(const IvToken& token, double& number) const {
    std::string_view text = token.text;
    if (text.starts_with('+')) text.remove_prefix(1);
    const char* end = text.data() + text.size();
    if (text.starts_with("0x") || text.starts_with("0X")) {
      u32 packed = 0;
      const std::from_chars_result hexadecimal = std::from_chars(text.data() + 2, end, packed, 16);
      number = packed;
      return hexadecimal.ec == std::errc() && hexadecimal.ptr == end;
    }
    const std::from_chars_result result = std::from_chars(text.data(), end, number);
    if (result.ptr != end || result.ec == std::errc::invalid_argument) return false;
    if (result.ec == std::errc::result_out_of_range && text.find("e-") + 1 + text.find("E-") + 1 > 0) {
      number = 0.0;
    } else if (result.ec != std::errc() || !(std::abs(number) <= 3.4e38)) {
      fail(token, in_quotes(token.text) + " is not a finite number");
    }
    return true;
  }

  IvDocument& document_;
  IvLexer lexer_;
  std::map<std::string_view, u32> defined_;
  u64 values_left_ = kMostValues;
};

void check_header(const IvDocument& document) {
  const std::string_view first = std::string_view(document.text).substr(0, document.text.find('\n'));
  const auto fail = [&](const std::string& what) { throw std::runtime_error(at_line(document.file, 1) + ": " + what); };
  if (first.starts_with("#VRML V2") || first.starts_with("#X3D")) {
    fail("VRML 2.0 is not supported; VRML 1.0 and Open Inventor are");
  }
  const bool vrml = first.starts_with("#VRML V1.0");
  if (!vrml && !first.starts_with("#Inventor V1") && !first.starts_with("#Inventor V2")) {
    fail("the first line is neither '#Inventor V1.0 ascii', '#Inventor V2.1 ascii' nor '#VRML V1.0 ascii'");
  }
  if (first.find("binary") != first.npos) fail("binary Open Inventor is not supported; ascii is");
  if (document.text.find('\0') != document.text.npos) fail("a zero byte: this is not text");
}

}  // namespace

std::unique_ptr<const IvDocument> parse_inventor(const std::filesystem::path& file, std::string text) {
  auto document = std::make_unique<IvDocument>();
  document->file = file;
  document->text = std::move(text);
  check_header(*document);
  IvParser(*document).parse();
  return document;
}

}  // namespace raywalk
