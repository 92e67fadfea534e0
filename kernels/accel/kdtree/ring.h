// The short stack's storage: a ring of a few entries; a push onto a full ring forgets the oldest. On the GPU it lies in
// shared memory, a column a thread, as in the study.
#pragma once
#include "kernels/knobs.h"
#include "kernels/lanes.h"

namespace raywalk::kdtree {

/// An entry is kWords words.
template <u32 kWords>
class Ring {
 public:
#if RW_GPU
  RW_FN explicit Ring(u32 /*entries*/) {}
#else
  /// 1 to kMaxStackEntries.
  explicit Ring(u32 entries) : entries_(entries) {}
#endif
  RW_FN void push(const u32* entry) {
    for (u32 i = 0; i < kWords; ++i) word(top_, i) = entry[i];
    top_ = top_ + 1 == entries_ ? 0 : top_ + 1;
    count_ = smaller(count_ + 1, entries_);
  }
  RW_FN bool pop(u32* entry) {
    if (count_ == 0) return false;
    --count_;
    top_ = (top_ == 0 ? entries_ : top_) - 1;
    for (u32 i = 0; i < kWords; ++i) entry[i] = word(top_, i);
    return true;
  }

 private:
#if RW_GPU
  RW_FN static u32& word(u32 place, u32 i) {
    RW_SHARED u32 words[entries_][kWords][RW_BLOCK];
    return words[place][i][threadIdx.x];
  }
  static constexpr u32 entries_ = RW_STACK_ENTRIES;
#else
  u32& word(u32 place, u32 i) {
    return words_[place][i];
  }
  u32 words_[kMaxStackEntries][kWords];
  u32 entries_;
#endif
  u32 top_ = 0;
  u32 count_ = 0;
};

}  // namespace raywalk::kdtree
