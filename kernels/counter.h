// Work counts of a traversal. Timed kernels are compiled with NoCounter, which costs nothing.
#pragma once
#include "kernels/platform.h"

namespace raywalk {

/// Rays traced, traversal steps (nodes or cells visited) and ray-triangle tests.
struct Counts {
  u64 rays, steps, tests;
  RW_FN Counts& operator+=(const Counts& other) {
    rays += other.rays;
    steps += other.steps;
    tests += other.tests;
    return *this;
  }
};

struct NoCounter {
  RW_FN void ray() {}
  RW_FN void step() {}
  RW_FN void test() {}
};

struct Counter {
  Counts counts{};
  RW_FN void ray() { ++counts.rays; }
  RW_FN void step() { ++counts.steps; }
  RW_FN void test() { ++counts.tests; }
};

}  // namespace raywalk
