// Host only: what a node of the kd-tree under construction holds, once for each way to find splits. Both have
//   size(), parts(), find_split(config, cell), split(source, cell, split, out[2]).
#pragma once
#include <utility>
#include <vector>

#include "kernels/accel/kdtree/cell.h"

namespace raywalk::kdtree {

/// The triangles being sorted into the tree.
struct Source {
  const Corners* corners;
  PaddedFrame frame;
};

/// Parts of a node with at least this many triangles are worked on by several threads.
constexpr u32 kParallelSize = 8192;

/// Parts and, for each axis, the sorted bounds of the parts: events. Children inherit the order; only the triangles
/// that straddle the split are sorted anew.
class ExactWork {
 public:
  /// Sorts the events of the root.
  explicit ExactWork(std::vector<Part> parts);
  ExactWork() = default;

  u32 size() const { return static_cast<u32>(parts_.size()); }
  const std::vector<Part>& parts() const { return parts_; }
  Split find_split(const Config& config, const Cell& cell) const;
  /// Leaves this object empty.
  void split(const Source& source, const Cell& cell, const Split& split, ExactWork (&out)[2]);

 private:
  /// Ascending as integers: position, ends before starts, part.
  using Event = u64;
  Split sweep(const Config& config, const Cell& cell, int axis) const;
  static void add_events(std::vector<Event>& events, const Part& part, u32 index, int axis);

  std::vector<Part> parts_;
  std::vector<Event> events_[3];
};

/// Parts only; splits are found by binning a sample of them.
class SampledWork {
 public:
  explicit SampledWork(std::vector<Part> parts) : parts_(std::move(parts)) {}
  SampledWork() = default;

  u32 size() const { return static_cast<u32>(parts_.size()); }
  const std::vector<Part>& parts() const { return parts_; }
  Split find_split(const Config& config, const Cell& cell) const;
  /// Leaves this object empty.
  void split(const Source& source, const Cell& cell, const Split& split, SampledWork (&out)[2]);

 private:
  std::vector<Part> parts_;
};

}  // namespace raywalk::kdtree
