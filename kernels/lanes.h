// Cooperative execution with one source: on the GPU every thread is a lane and holds its own values; on the
// CPU one thread holds the values of all lanes in arrays and loops over them.
#pragma once
#include "kernels/platform.h"

/// Storage shared by the threads of a block: declare an array with it inside a function, one row a group.
#if RW_GPU
#define RW_SHARED __shared__
#else
#define RW_SHARED
#endif

namespace raywalk {

/// N lanes, of which this thread holds kLocal: write `for (u32 i = 0; i < kLocal; ++i)` around whatever a lane does.
/// The collectives take kLocal values a thread and give every thread the same answer. All lanes of the group call them
/// together, and they order accesses to the group's shared storage before and after.
/// On the GPU a group is a warp.
template <u32 N>
struct Lanes {
  static constexpr u32 kCount = N;

#if RW_GPU
  static_assert(N == 32, "a group is a warp");
  static constexpr u32 kLocal = 1;
  static constexpr u32 kGroups = RW_BLOCK / N;  // in a block

  /// Of the thread, in its block: the row of shared storage that is its group's.
  RW_FN static u32 group() {
    return threadIdx.x / N;
  }
  /// True in one thread of the group: the one that writes to shared storage.
  RW_FN static bool leads() {
    return threadIdx.x % N == 0;
  }
  RW_FN static void barrier() {
    __syncwarp();
  }
  RW_FN static bool any(const bool* flags) {
    return __any_sync(~0u, flags[0]) != 0;
  }
  RW_FN static u32 sum(const u32* values) {
    return __reduce_add_sync(~0u, values[0]);
  }
#else
  static constexpr u32 kLocal = N;
  static constexpr u32 kGroups = 1;

  static u32 group() {
    return 0;
  }
  static bool leads() {
    return true;
  }
  static void barrier() {}
  static bool any(const bool* flags) {
    bool answer = false;
    for (u32 i = 0; i < N; ++i) answer |= flags[i];
    return answer;
  }
  static u32 sum(const u32* values) {
    u32 answer = 0;
    for (u32 i = 0; i < N; ++i) answer += values[i];
    return answer;
  }
#endif
};

}  // namespace raywalk
