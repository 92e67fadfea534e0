// The header of a PLY file: encoding, elements and their properties.
#pragma once
#include <string>
#include <vector>

#include "server/scene/byte_reader.h"

namespace raywalk {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

u32 size_bytes_of(PlyType type);
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;  // of the value, or of a list's items
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  // lists only; always an integer type
};

struct PlyElement {
  std::string name;
  u64 count;
  std::vector<PlyProperty> properties;
  /// Bytes that one row takes at least (lists empty, text values one digit long).
  u64 least_row_bytes(PlyEncoding encoding) const;
  /// Index of the property, or -1.
  int find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding;
  std::vector<PlyElement> elements;
};

/// Leaves the reader at the first byte of the data. Counts are checked against the size of the file.
/// Throws std::runtime_error naming file and line.
PlyHeader read_ply_header(ByteReader& reader);

}  // namespace raywalk
