// PLY: text and binary of either byte order, any order of elements and properties.
#include <algorithm>

#include "server/scene/byte_reader.h"
#include "server/scene/formats/formats.h"
#include "server/scene/formats/ply/header.h"
#include "server/scene/formats/ply/rows.h"
#include "server/scene/triangulate.h"

namespace raywalk {
namespace {

constexpr u64 kMostElements = 0xffffffffull;
constexpr long long kMostCorners = 1000;  // of one face: cutting ears is quadratic
constexpr long long kMostMaterials = 65'536;

template <class Rows>
class PlyBody {
 public:
  PlyBody(ByteReader& reader, const PlyHeader& header) : reader_(reader), header_(header), rows_(reader) {}

  Scene read() {
    if (vertices_ = find("vertex"); vertices_ == nullptr) rows_.fail("the header has no element 'vertex'");
    if (vertices_->count > kMostElements) rows_.fail("more than 2^32 - 1 vertices");
    faces_ = find("face");
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // its rows take no space, however many there are said to be
      if (&element == vertices_) {
        read_vertices(element);
      } else if (&element == faces_) {
        read_faces(element);
      } else {
        rows_.ignore_rows(element);
      }
    }
    if (!have_vertices_) rows_.fail("element 'vertex' has no properties");
    cut_late_polygons();
    finish();
    return std::move(scene_);
  }

 private:
  const PlyElement* find(std::string_view name) const {
    for (const PlyElement& e : header_.elements) {
      if (e.name == name) return &e;
    }
    return nullptr;
  }

  /// How many rows to reserve for: what a lying count in a small gzip file must not make large.
  u64 rows_to_reserve(const PlyElement& element) const {
    return std::min(element.count, reader_.likely_bytes_left() / element.least_row_bytes(header_.encoding) + 1);
  }

  void read_vertices(const PlyElement& element) {
    enum Role { kX, kY, kZ, kNx, kNy, kNz, kNone };
    static constexpr const char* kNames[] = {"x", "y", "z", "nx", "ny", "nz"};
    std::vector<Role> roles(element.properties.size(), kNone);
    u32 present = 0;
    for (int role = kX; role < kNone; ++role) {
      const int at = element.find(kNames[role]);
      if (at < 0) {
        if (role <= kZ) rows_.fail(std::string("element 'vertex' has no property '") + kNames[role] + "'");
        continue;
      }
      if (element.properties[at].is_list) rows_.fail(std::string("property '") + kNames[role] + "' cannot be a list");
      roles[at] = static_cast<Role>(role);
      present |= 1u << role;
    }
    const bool has_normals = (present >> kNx) == 7u;
    scene_.positions.reserve(rows_to_reserve(element));
    if (has_normals) scene_.normals.reserve(rows_to_reserve(element));

    u64 not_finite = 0;
    for (u64 row = 0; row < element.count; ++row) {
      rows_.begin_row(element, row);
      float value[kNone + 1] = {};
      for (size_t i = 0; i < roles.size(); ++i) {
        if (element.properties[i].is_list) {
          ignore_list(element.properties[i]);
        } else if (roles[i] == kNone) {
          rows_.ignore(element.properties[i].type);
        } else {
          value[roles[i]] = rows_.real(element.properties[i].type);
        }
      }
      rows_.end_row();
      scene_.positions.push_back({value[kX], value[kY], value[kZ]});
      if (has_normals) scene_.normals.push_back({value[kNx], value[kNy], value[kNz]});
      not_finite += !is_finite(scene_.positions.back());
    }
    have_vertices_ = true;
    if (not_finite > 0) warn(std::to_string(not_finite) + " vertices are not finite: their triangles are never hit");
  }

  void read_faces(const PlyElement& element) {
    int corners_at = element.find("vertex_indices");
    if (corners_at < 0) corners_at = element.find("vertex_index");
    if (corners_at < 0) rows_.fail("element 'face' has neither property 'vertex_indices' nor 'vertex_index'");
    const PlyProperty& list = element.properties[corners_at];
    if (!list.is_list || !is_integer(list.type)) rows_.fail("property '" + list.name + "' must be a list of integers");
    int material_at = element.find("material_index");
    if (material_at >= 0 &&
        (element.properties[material_at].is_list || !is_integer(element.properties[material_at].type))) {
      rows_.fail("property 'material_index' must be an integer");
    }
    scene_.triangles.reserve(std::min(kMostElements, rows_to_reserve(element)));

    for (u64 row = 0; row < element.count; ++row) {
      rows_.begin_row(element, row);
      long long material = 0;
      for (int i = 0; i < static_cast<int>(element.properties.size()); ++i) {
        const PlyProperty& p = element.properties[i];
        if (i == corners_at) {
          read_corners(p);
        } else if (i == material_at) {
          material = rows_.integer(p.type);
          if (material < 0 || material >= kMostMaterials) {
            rows_.fail("material index " + std::to_string(material) + " is not in 0 to " +
                       std::to_string(kMostMaterials - 1));
          }
        } else if (p.is_list) {
          ignore_list(p);
        } else {
          rows_.ignore(p.type);
        }
      }
      rows_.end_row();
      add_face(static_cast<u32>(material));
    }
  }

  long long list_length(const PlyProperty& list) {
    const long long length = rows_.integer(list.count_type);
    if (length < 0) rows_.fail("list '" + list.name + "' has the length " + std::to_string(length));
    return length;
  }
  void ignore_list(const PlyProperty& list) {
    for (long long n = list_length(list); n > 0; --n) rows_.ignore(list.type);
  }

  void read_corners(const PlyProperty& list) {
    const long long length = list_length(list);
    if (length > kMostCorners) {
      rows_.fail("a face with " + std::to_string(length) + " corners; the most is " + std::to_string(kMostCorners));
    }
    corners_.clear();
    for (long long i = 0; i < length; ++i) {
      const long long index = rows_.integer(list.type);
      if (index < 0 || static_cast<u64>(index) >= vertices_->count) {
        rows_.fail("vertex index " + std::to_string(index) + " is out of range: there are " +
                   std::to_string(vertices_->count) + " vertices");
      }
      corners_.push_back(static_cast<u32>(index));
    }
  }

  void add_face(u32 material) {
    most_material_ = std::max(most_material_, material);
    if (corners_.size() < 3) {
      ++not_faces_;
    } else if (corners_.size() == 3) {
      scene_.triangles.push_back({corners_[0], corners_[1], corners_[2], material});
    } else if (have_vertices_) {
      for (const TriangleIndices& t : cut(corners_, material)) scene_.triangles.push_back(t);
    } else {
      // Faces before vertices: keep the places, cut when the positions are known.
      late_.push_back({scene_.triangles.size(), late_corners_.size(), corners_.size()});
      late_corners_.insert(late_corners_.end(), corners_.begin(), corners_.end());
      scene_.triangles.resize(scene_.triangles.size() + corners_.size() - 2, {0, 0, 0, material});
    }
    if (scene_.triangles.size() > kMostElements) rows_.fail("more than 2^32 - 1 triangles");
  }

  std::vector<TriangleIndices> cut(std::span<const u32> corners, u32 material) const {
    const std::vector<u32> cut_corners = triangulate(corners, scene_.positions);
    std::vector<TriangleIndices> triangles;
    for (size_t i = 0; i < cut_corners.size(); i += 3) {
      triangles.push_back({cut_corners[i], cut_corners[i + 1], cut_corners[i + 2], material});
    }
    return triangles;
  }

  void cut_late_polygons() {
    for (const LatePolygon& p : late_) {
      const u32 material = scene_.triangles[p.first_triangle].material;
      const std::vector<TriangleIndices> triangles =
          cut(std::span(late_corners_).subspan(p.first_corner, p.corners), material);
      std::copy(triangles.begin(), triangles.end(),
                scene_.triangles.begin() + static_cast<std::ptrdiff_t>(p.first_triangle));
    }
  }

  void finish() {
    if (not_faces_ > 0) warn(std::to_string(not_faces_) + " faces with fewer than three corners are left out");
    if (scene_.triangles.empty()) warn("the file has no faces");
    scene_.materials.assign(most_material_ + 1, default_material());
  }
  void warn(const std::string& message) { scene_.warnings.push_back(reader_.path().string() + ": " + message); }

  struct LatePolygon {
    size_t first_triangle, first_corner, corners;
  };

  ByteReader& reader_;
  const PlyHeader& header_;
  Rows rows_;
  const PlyElement* vertices_ = nullptr;
  const PlyElement* faces_ = nullptr;
  Scene scene_;
  bool have_vertices_ = false;
  std::vector<u32> corners_;
  std::vector<LatePolygon> late_;
  std::vector<u32> late_corners_;
  u64 not_faces_ = 0;
  u32 most_material_ = 0;
};

bool begins_as_ply(std::span<const u8> head) {
  return head.size() >= 4 && head[0] == 'p' && head[1] == 'l' && head[2] == 'y' && (head[3] == '\n' || head[3] == '\r');
}

Scene load_ply(ImportFiles& files) {
  ByteReader reader(files.main());
  const PlyHeader header = read_ply_header(reader);
  switch (header.encoding) {
    case PlyEncoding::kLittleEndian:
      return PlyBody<PlyBinaryRows<false>>(reader, header).read();
    case PlyEncoding::kBigEndian:
      return PlyBody<PlyBinaryRows<true>>(reader, header).read();
    case PlyEncoding::kAscii:
      break;
  }
  return PlyBody<PlyTextRows>(reader, header).read();
}

}  // namespace

extern const Format k_ply_format;
const Format k_ply_format = {"PLY", {".ply"}, begins_as_ply, load_ply};

}  // namespace raywalk
