// Parsing of PLY headers.
#include "server/scene/formats/ply/header.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <optional>

#include "server/scene/text.h"

namespace raywalk {
namespace {

std::optional<PlyType> type_named(std::string_view name) {
  static const std::map<std::string_view, PlyType> types = {
      {"char", PlyType::kInt8},     {"int8", PlyType::kInt8},     {"uchar", PlyType::kUint8},
      {"uint8", PlyType::kUint8},   {"short", PlyType::kInt16},   {"int16", PlyType::kInt16},
      {"ushort", PlyType::kUint16}, {"uint16", PlyType::kUint16}, {"int", PlyType::kInt32},
      {"int32", PlyType::kInt32},   {"uint", PlyType::kUint32},   {"uint32", PlyType::kUint32},
      {"float", PlyType::kFloat},   {"float32", PlyType::kFloat}, {"double", PlyType::kDouble},
      {"float64", PlyType::kDouble}};
  const auto found = types.find(name);
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

class HeaderParser {
 public:
  explicit HeaderParser(ByteReader& reader) : reader_(reader) {}

  PlyHeader parse() {
    std::string_view line;
    if (!reader_.next_line(line) || line != "ply") reader_.fail_at_line("a PLY file begins with the line 'ply'");
    bool has_format = false;
    while (true) {
      if (!reader_.next_line(line)) reader_.fail_at_line("the file ends before 'end_header'");
      if (reader_.byte() > kLongestHeader) reader_.fail_at_line("the header is longer than 1 MiB");
      TokenReader words(line);
      const std::string_view keyword = words.next();
      if (keyword == "end_header") break;
      if (keyword == "format") {
        read_format(words);
        has_format = true;
      } else if (keyword == "element") {
        read_element(words);
      } else if (keyword == "property") {
        read_property(words);
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        reader_.fail_at_line("unknown keyword " + in_quotes(keyword));
      }
    }
    if (!has_format) reader_.fail_at_line("the header has no 'format' line");
    check_counts();
    return std::move(header_);
  }

 private:
  static constexpr u64 kLongestHeader = 1 << 20;

  void read_format(TokenReader& words) {
    const std::string_view name = words.next();
    if (name == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::kLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBigEndian;
    } else {
      reader_.fail_at_line("unknown format " + in_quotes(name));
    }
    const std::string_view version = words.next();
    if (version != "1.0") reader_.fail_at_line("unknown format version " + in_quotes(version));
  }

  void read_element(TokenReader& words) {
    PlyElement element{std::string(words.next()), 0, {}};
    const std::string_view count = words.next();
    if (element.name.empty()) reader_.fail_at_line("an element without a name");
    if (!parse_number(count, element.count)) {
      reader_.fail_at_line("element " + element.name + ": " + in_quotes(count) + " is not a count");
    }
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name) reader_.fail_at_line("a second element " + in_quotes(element.name));
    }
    header_.elements.push_back(std::move(element));
  }

  void read_property(TokenReader& words) {
    if (header_.elements.empty()) reader_.fail_at_line("a property before any element");
    PlyElement& element = header_.elements.back();
    PlyProperty property;
    std::string_view type = words.next();
    if (type == "list") {
      property.is_list = true;
      property.count_type = read_type(words.next());
      if (!is_integer(property.count_type)) reader_.fail_at_line("the length of a list cannot be a float");
      type = words.next();
    }
    property.type = read_type(type);
    property.name = words.next();
    if (property.name.empty()) reader_.fail_at_line("a property without a name");
    if (element.find(property.name) >= 0) reader_.fail_at_line("a second property " + in_quotes(property.name));
    element.properties.push_back(std::move(property));
  }

  PlyType read_type(std::string_view name) {
    const std::optional<PlyType> type = type_named(name);
    if (!type) reader_.fail_at_line("unknown type " + in_quotes(name));
    return *type;
  }

  void check_counts() {
    u64 left = reader_.most_bytes_left();
    // The last line of a text file may lack its end.
    if (header_.encoding == PlyEncoding::kAscii) ++left;
    for (const PlyElement& element : header_.elements) {
      const u64 row = element.least_row_bytes(header_.encoding);
      if (row > 0 && element.count > left / row) {
        reader_.fail_at_line("element " + element.name + ": " + std::to_string(element.count) +
                             " rows cannot fit in the rest of the file (truncated, or the count is wrong)");
      }
      left -= row * element.count;
    }
  }

  ByteReader& reader_;
  PlyHeader header_{};
};

}  // namespace

u32 size_bytes_of(PlyType type) {
  constexpr u32 kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<int>(type)];
}

bool is_integer(PlyType type) {
  return type < PlyType::kFloat;
}

u64 PlyElement::least_row_bytes(PlyEncoding encoding) const {
  u64 bytes = 0;
  for (const PlyProperty& p : properties) {
    if (encoding == PlyEncoding::kAscii) {
      bytes += 2;  // a digit and a space or line end
    } else {
      bytes += size_bytes_of(p.is_list ? p.count_type : p.type);
    }
  }
  return bytes;
}

int PlyElement::find(std::string_view property) const {
  for (size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return static_cast<int>(i);
  }
  return -1;
}

PlyHeader read_ply_header(ByteReader& reader) {
  return HeaderParser(reader).parse();
}

}  // namespace raywalk
