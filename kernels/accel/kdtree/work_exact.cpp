// Exact SAH: sweeps sorted events and splits them in linear time.
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "kernels/accel/kdtree/work.h"

namespace raywalk::kdtree {
namespace {

constexpr u64 kStart = u64{1} << 31;  // of a part; else its end
constexpr u64 kIndex = kStart - 1;

/// Order-preserving map of floats to unsigned integers, and back.
u32 ordered(float a) {
  const u32 bits = bits_of(a);
  return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}
float position_of(u64 event) {
  const u32 bits = static_cast<u32>(event >> 32);
  return float_of((bits & 0x80000000u) != 0 ? bits & 0x7fffffffu : ~bits);
}

void for_each_axis(u32 size, const auto& body) {
  if (size >= kParallelSize) {
    tbb::parallel_for(0, 3, body);
  } else {
    for (int axis = 0; axis < 3; ++axis) body(axis);
  }
}

/// Merges sorted `fresh` into sorted `events` from the back, without a copy.
void merge_into(std::vector<u64>& events, const std::vector<u64>& fresh) {
  size_t kept = events.size(), added = fresh.size();
  events.resize(kept + added);
  for (size_t to = events.size(); added > 0;) {
    const bool take_kept = kept > 0 && events[kept - 1] > fresh[added - 1];
    events[--to] = take_kept ? events[--kept] : fresh[--added];
  }
}

}  // namespace

void ExactWork::add_events(std::vector<Event>& events, const Part& part, u32 index, int axis) {
  events.push_back(u64{ordered(part.bounds.lo[axis])} << 32 | kStart | index);
  events.push_back(u64{ordered(part.bounds.hi[axis])} << 32 | index);
}

ExactWork::ExactWork(std::vector<Part> parts) : parts_(std::move(parts)) {
  for_each_axis(size(), [&](int axis) {
    events_[axis].reserve(2 * parts_.size());
    for (u32 i = 0; i < size(); ++i) add_events(events_[axis], parts_[i], i, axis);
    tbb::parallel_sort(events_[axis].begin(), events_[axis].end());
  });
}

Split ExactWork::sweep(const Config& config, const Cell& cell, int axis) const {
  CheapestSplit cheapest(config, cell, axis);
  u64 left = 0, right = size();
  const std::vector<Event>& events = events_[axis];
  for (size_t i = 0; i < events.size();) {
    const u64 position = events[i] >> 32;
    const float plane = position_of(events[i]);
    for (; i < events.size() && events[i] >> 32 == position && (events[i] & kStart) == 0; ++i) --right;
    cheapest.consider(plane, left, right);
    for (; i < events.size() && events[i] >> 32 == position; ++i) ++left;
  }
  return cheapest.best();
}

Split ExactWork::find_split(const Config& config, const Cell& cell) const {
  Split best[3];
  for_each_axis(size(), [&](int axis) { best[axis] = sweep(config, cell, axis); });
  return cheaper(cheaper(best[0], best[1]), best[2]);
}

void ExactWork::split(const Source& source, const Cell& cell, const Split& split, ExactWork (&out)[2]) {
  constexpr u32 kGone = ~0u;
  struct Place {
    u32 index[2];  // of the part in each child
    bool fresh;    // it straddles: its events are made anew
  };
  std::vector<Place> places(parts_.size());
  u32 counts[3] = {0, 0, 0};
  for (const Part& part : parts_) ++counts[side_of(part, split)];
  for (int side : {0, 1}) out[side].parts_.reserve(counts[side] + counts[2]);
  std::vector<u32> fresh[2];
  for (u32 i = 0; i < size(); ++i) {
    const int at = side_of(parts_[i], split);
    places[i] = {{kGone, kGone}, at == 2};
    for (int side : {0, 1}) {
      if (at != 2 && at != side) continue;
      Part part = parts_[i];
      if (at == 2 && !clip(source.frame, source.corners[part.id], child_of(cell, split, side), part)) continue;
      places[i].index[side] = out[side].size();
      if (at == 2) fresh[side].push_back(out[side].size());
      out[side].parts_.push_back(part);
    }
  }
  const u32 total = size();
  std::vector<Part>().swap(parts_);

  for_each_axis(total, [&](int axis) {
    for (int side : {0, 1}) out[side].events_[axis].reserve(2 * out[side].parts_.size());
    for (const Event event : events_[axis]) {
      const Place& place = places[event & kIndex];
      if (place.fresh) continue;
      const int side = place.index[0] == kGone ? 1 : 0;
      out[side].events_[axis].push_back((event & ~kIndex) | place.index[side]);
    }
    std::vector<Event>().swap(events_[axis]);
    std::vector<Event> more;
    for (int side : {0, 1}) {
      more.clear();
      for (const u32 i : fresh[side]) add_events(more, out[side].parts_[i], i, axis);
      std::sort(more.begin(), more.end());
      merge_into(out[side].events_[axis], more);
    }
  });
}

}  // namespace raywalk::kdtree
