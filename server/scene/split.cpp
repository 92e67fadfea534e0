// A queue of edges by length, and for each edge the triangles that have it.
#include "server/scene/split.h"

#include <array>
#include <bit>
#include <optional>
#include <queue>
#include <stdexcept>
#include <unordered_map>

namespace raywalk {
namespace {

/// Spreads keys whose halves are small numbers.
struct Mixed {
  size_t operator()(u64 key) const { return (key ^ (key >> 31)) * 0x9e3779b97f4a7c15ull >> 7; }
};

struct EdgeTriangles {
  std::array<u32, 2> triangle;
  u32 count;  // more than 2: only two of them are kept
};

struct QueuedEdge {
  float squared_length;
  u64 edge;
  /// The longest first, equally long ones by their ends.
  bool operator<(const QueuedEdge& other) const {
    return squared_length != other.squared_length ? squared_length < other.squared_length : edge > other.edge;
  }
};

class EdgeSplitter {
 public:
  explicit EdgeSplitter(Scene& scene) : scene_(scene) {
    weld();
    edges_.reserve(2 * scene.triangles.size());
    for (u32 t = 0; t < scene.triangles.size(); ++t) {
      const TriangleIndices& i = scene.triangles[t];
      add(i.a, i.b, t);
      add(i.b, i.c, t);
      add(i.c, i.a, t);
    }
    for (const auto& [edge, unused] : edges_) enqueue(edge);
  }

  void split_to(u64 triangles) {
    while (scene_.triangles.size() < triangles && !queue_.empty()) {
      const u64 edge = queue_.top().edge;
      queue_.pop();
      const auto found = edges_.find(edge);
      if (found == edges_.end() || found->second.count > 2) continue;
      const EdgeTriangles sides = found->second;
      // A triangle without area, two of whose corners are at one place, has the edge twice.
      if (sides.count == 2 && sides.triangle[0] == sides.triangle[1]) continue;
      if (scene_.triangles.size() + sides.count > triangles || !is_longest(edge, sides)) continue;
      halve(edge, sides);
    }
    if (scene_.triangles.size() + 1 == triangles) {
      if (const std::optional<u64> rim = longest_rim()) halve(*rim, edges_.at(*rim));
    }
    if (scene_.triangles.size() < triangles) {
      throw std::invalid_argument("the mesh cannot be split to " + std::to_string(triangles) + " triangles");
    }
  }

 private:
  /// Vertices at the same place get the number of the first of them.
  void weld() {
    std::unordered_map<u64, std::vector<u32>, Mixed> at;
    at.reserve(scene_.positions.size());
    place_.resize(scene_.positions.size());
    for (u32 i = 0; i < scene_.positions.size(); ++i) {
      const Vec3 p = scene_.positions[i] + Vec3{0, 0, 0};  // one zero
      const u64 key = (u64{std::bit_cast<u32>(p.x)} << 32 | std::bit_cast<u32>(p.y)) ^
                      u64 { std::bit_cast<u32>(p.z) } * 0x9e3779b1u;
      std::vector<u32>& near = at[key];
      place_[i] = i;
      for (const u32 other : near) {
        if (scene_.positions[other] == p) place_[i] = other;
      }
      if (place_[i] == i) near.push_back(i);
    }
  }

  u64 edge_of(u32 a, u32 b) const {
    const u64 p = place_[a], q = place_[b];
    return p < q ? p << 32 | q : q << 32 | p;
  }

  void add(u32 a, u32 b, u32 triangle) {
    if (place_[a] == place_[b]) return;
    EdgeTriangles& sides = edges_.try_emplace(edge_of(a, b), EdgeTriangles{{0, 0}, 0}).first->second;
    if (sides.count < 2) sides.triangle[sides.count] = triangle;
    ++sides.count;
  }

  void enqueue(u64 edge) {
    const float squared = squared_length(edge);
    if (squared > 0.0f && squared <= kMaxFloat) queue_.push({squared, edge});
  }

  float squared_length(u64 edge) const {
    const Vec3 d = scene_.positions[edge >> 32] - scene_.positions[edge & 0xffffffffu];
    return dot(d, d);
  }

  /// Whether no triangle of the edge has a longer one. That would be an edge that stays, and halving the shorter ones
  /// again and again would make triangles ever thinner, but none of them shorter.
  bool is_longest(u64 edge, const EdgeTriangles& sides) const {
    const float squared = squared_length(edge);
    for (u32 side = 0; side < sides.count; ++side) {
      const TriangleIndices& t = scene_.triangles[sides.triangle[side]];
      for (const u64 other : {edge_of(t.a, t.b), edge_of(t.b, t.c), edge_of(t.c, t.a)}) {
        if (squared_length(other) > squared) return false;
      }
    }
    return true;
  }

  /// The longest edge of a single triangle; nothing if there is none.
  std::optional<u64> longest_rim() const {
    std::optional<QueuedEdge> longest;
    for (const auto& [edge, sides] : edges_) {
      const QueuedEdge rim{squared_length(edge), edge};
      if (sides.count == 1 && rim.squared_length > 0.0f && (!longest || *longest < rim)) longest = rim;
    }
    return longest ? std::optional(longest->edge) : std::nullopt;
  }

  u32 middle_of(u32 a, u32 b) {
    scene_.positions.push_back(0.5f * scene_.positions[a] + 0.5f * scene_.positions[b]);
    if (!scene_.normals.empty()) {
      const Vec3 n = scene_.normals[a] + scene_.normals[b];
      scene_.normals.push_back(dot(n, n) > 0.0f ? normalized(n) : Vec3{0, 0, 0});
    }
    if (!scene_.texcoords.empty()) {
      const TexCoord s = scene_.texcoords[a], t = scene_.texcoords[b];
      scene_.texcoords.push_back({0.5f * (s.s + t.s), 0.5f * (s.t + t.t)});
    }
    return static_cast<u32>(scene_.positions.size() - 1);
  }

  void halve(u64 edge, const EdgeTriangles sides) {
    edges_.erase(edge);
    u32 ends[2] = {}, middle = 0, first_middle = 0;
    for (u32 side = 0; side < sides.count; ++side) {
      const u32 t = sides.triangle[side];
      const auto [a, b, c] = turned(scene_.triangles[t], edge);
      const bool shared = side == 1 && ends[0] == b && ends[1] == a;
      if (!shared) {
        middle = middle_of(a, b);
        if (side == 0) first_middle = middle;
        place_.push_back(first_middle);
      }
      ends[0] = a;
      ends[1] = b;
      const u32 added = static_cast<u32>(scene_.triangles.size());
      scene_.triangles.push_back({middle, b, c, scene_.triangles[t].material});
      scene_.triangles[t] = {a, middle, c, scene_.triangles[t].material};
      if (const auto outer = edges_.find(edge_of(b, c)); outer != edges_.end()) {
        for (u32& triangle : outer->second.triangle) {
          if (triangle == t) triangle = added;
        }
      }
      add(a, middle, t);
      add(middle, b, added);
      add(middle, c, t);
      add(middle, c, added);
      enqueue(edge_of(middle, c));
      if (side == 0) {
        enqueue(edge_of(a, middle));
        enqueue(edge_of(middle, b));
      }
    }
  }

  /// The corners of a triangle, turned so that the edge is between the first two.
  std::array<u32, 3> turned(const TriangleIndices& t, u64 edge) const {
    if (edge_of(t.a, t.b) == edge) return {t.a, t.b, t.c};
    if (edge_of(t.b, t.c) == edge) return {t.b, t.c, t.a};
    return {t.c, t.a, t.b};
  }

  Scene& scene_;
  std::vector<u32> place_;  // of each vertex: the first vertex at its position
  std::unordered_map<u64, EdgeTriangles, Mixed> edges_;
  std::priority_queue<QueuedEdge> queue_;
};

}  // namespace

void split_edges(Scene& scene, u64 triangles) {
  if (scene.triangles.size() > triangles) {
    throw std::invalid_argument("the mesh has " + std::to_string(scene.triangles.size()) +
                                " triangles and cannot be split to " + std::to_string(triangles));
  }
  EdgeSplitter(scene).split_to(triangles);
}

}  // namespace raywalk
