// Cooperative execution with one source: on the GPU every thread of a block is a lane and holds its own values; on the
// CPU one thread holds the values of all lanes in arrays and loops over them.
#pragma once
#include "kernels/platform.h"

/// Storage shared by the lanes of a block: declare an array with it inside a function.
#if RW_GPU
#define RW_SHARED __shared__
#else
#define RW_SHARED
#endif

namespace raywalk {

/// N lanes, of which this thread holds kLocal: write `for (u32 i = 0; i < kLocal; ++i)` around whatever a lane does.
/// The collectives take kLocal values a thread and give every thread the same answer. All lanes of the block call them
/// together, and they order accesses to shared storage before and after.
template <u32 N>
struct Lanes {
  static constexpr u32 kCount = N;

#if RW_GPU
  static_assert(N % 32 == 0);
  static constexpr u32 kLocal = 1;

  /// True in one thread only: the one that writes to shared storage.
  RW_FN static bool leads() {
    return threadIdx.x + threadIdx.y * blockDim.x == 0;
  }
  RW_FN static void barrier() {
    __syncthreads();
  }
  RW_FN static bool any(const bool* flags) {
    return __syncthreads_or(flags[0]) != 0;
  }
  /// Bit k of the answer is set when any lane votes k; votes are 0 to 31.
  RW_FN static u32 vote(const u32* votes) {
    return combined(__reduce_or_sync(~0u, 1u << votes[0]), Or{});
  }
  RW_FN static i32 sum(const i32* values) {
    return static_cast<i32>(combined(static_cast<u32>(__reduce_add_sync(~0u, values[0])), Add{}));
  }

 private:
  struct Or {
    RW_FN u32 operator()(u32 a, u32 b) const { return a | b; }
  };
  struct Add {
    RW_FN u32 operator()(u32 a, u32 b) const { return a + b; }
  };
  template <class Operation>
  RW_FN static u32 combined(u32 of_warp, Operation operation) {
    RW_SHARED u32 of_warps[N / 32];
    const u32 thread = threadIdx.x + threadIdx.y * blockDim.x;
    if (thread % 32 == 0) of_warps[thread / 32] = of_warp;
    __syncthreads();
    u32 all = of_warps[0];
    for (u32 i = 1; i < N / 32; ++i) all = operation(all, of_warps[i]);
    __syncthreads();  // before the next use of of_warps
    return all;
  }
#else
  static constexpr u32 kLocal = N;

  static bool leads() {
    return true;
  }
  static void barrier() {}
  static bool any(const bool* flags) {
    bool answer = false;
    for (u32 i = 0; i < N; ++i) answer |= flags[i];
    return answer;
  }
  static u32 vote(const u32* votes) {
    u32 answer = 0;
    for (u32 i = 0; i < N; ++i) answer |= 1u << votes[i];
    return answer;
  }
  static i32 sum(const i32* values) {
    i32 answer = 0;
    for (u32 i = 0; i < N; ++i) answer += values[i];
    return answer;
  }
#endif
};

}  // namespace raywalk
