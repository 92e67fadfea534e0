// Uniform grid as stored: cell (x, y, z) has number x + nx * (y + ny * z) and owns a run of references.
#pragma once
#include "kernels/accel/padded_frame.h"
#include "kernels/accel/records.h"
#include "kernels/blob.h"

namespace raywalk::grid {

struct Header {
  PaddedFrame frame;
  u32 resolution[3];
  u32 pad;
  Vec3 cell;                    // size of a cell
  Vec3 inverse;                 // cells a length
  Slice<u32> begins;            // one a cell and one more: its references are [begins[i], begins[i + 1])
  Slice<u32> references;        // triangle ids, ascending in each cell
  Slice<Transform> transforms;  // by id; none unless they were asked for

  /// Position of border i along one axis in the frame; border 0 is the low side of cell 0.
  RW_FN float border(u32 axis, i32 i) const { return fma(static_cast<float>(i), cell[axis], -frame.half[axis]); }
  /// The cell along one axis that holds a position, clamped to the grid.
  RW_FN i32 cell_of(u32 axis, float position) const {
    const float at = (position + frame.half[axis]) * inverse[axis];
    return static_cast<i32>(smaller(larger(at, 0.0f), static_cast<float>(resolution[axis] - 1)));
  }
  RW_FN u32 number(i32 x, i32 y, i32 z) const {
    return static_cast<u32>(x) + resolution[0] * (static_cast<u32>(y) + resolution[1] * static_cast<u32>(z));
  }
};

/// Tests the triangles of references [begin, end). True when the traversal is finished.
template <class Query, class Counter>
RW_FN bool test_cell(const u32* references, u32 begin, u32 end, const typename Query::Record* records, Query& query,
                     Counter& counter) {
  for (u32 i = begin; i < end; ++i) {
    counter.test();
    if (query.test(records[references[i]])) return true;
  }
  return false;
}

}  // namespace raywalk::grid
