// Where generators pour their triangles: a scene in memory, a file, or nothing but counters.
#pragma once
#include "kernels/scene_view.h"

namespace raywalk {

struct MeshCounts {
  u64 vertices = 0;
  u64 triangles = 0;
};

class TriangleSink {
 public:
  virtual ~TriangleSink() = default;
  /// Called once, first, with what will come exactly.
  virtual void begin(MeshCounts counts) = 0;
  /// True if positions and normals are not looked at, so that they need not be worked out.
  virtual bool counts_only() const { return false; }
  /// The index of the vertex: they are counted from 0 in the order of the calls. `normal` is a unit vector.
  virtual u32 add_vertex(Vec3 position, Vec3 normal) = 0;
  /// The vertices may come later.
  virtual void add_triangle(TriangleIndices triangle) = 0;
};

/// Counts, so that a generator can be run once dry.
class CountingSink : public TriangleSink {
 public:
  void begin(MeshCounts) override {}
  bool counts_only() const override { return true; }
  u32 add_vertex(Vec3, Vec3) override { return static_cast<u32>(counts_.vertices++); }
  void add_triangle(TriangleIndices) override { ++counts_.triangles; }
  MeshCounts counts() const { return counts_; }

 private:
  MeshCounts counts_;
};

}  // namespace raywalk
