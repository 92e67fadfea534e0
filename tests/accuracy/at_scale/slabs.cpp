// Every hit that a strict triangle test gives lies in the triangle's box by the box test: else a tree would lose it.
#include <array>
#include <optional>

#include "kernels/accel/bvh/pair.h"
#include "kernels/triangle/exact.h"
#include "kernels/triangle/watertight.h"
#include "server/accuracy/cases/exam.h"
#include "server/accuracy/cases/hex.h"
#include "server/system/stopwatch.h"
#include "tests/accuracy/at_scale/boxed_pair.h"
#include "tests/accuracy/at_scale/run.h"
#include "tests/accuracy/at_scale/workers.h"

namespace raywalk::at_scale {
namespace {

constexpr u32 kRaysOfPair = 64;  // at each of both triangles

/// A box test with a format of nodes.
struct Test {
  const char* name;
  bool strict;
  /// Whether the interval of the box on that side includes t.
  bool (*includes)(const BoxedPair& pair, u32 side, const Ray& ray, float t);
};

/// As a traversal asks when a hit at t is all that can still count.
template <class Slab, class NodeT>
bool includes(const BoxedPair& pair, const NodeT& node, u32 side, const Ray& ray, float t) {
  const bvh::PairSlabs<Slab> slabs(ray, pair.header());
  const bvh::PairEntries entries = bvh::entries_of(slabs, node, pair.header().unit, bvh::PairLimits{t, t});
  return side == 0 ? entries.meets_left && entries.left <= t : entries.meets_right && entries.right <= t;
}

template <class Slab>
bool in_floats(const BoxedPair& pair, u32 side, const Ray& ray, float t) {
  return includes<Slab>(pair, pair.node(), side, ray, t);
}
bool in_halves(const BoxedPair& pair, u32 side, const Ray& ray, float t) {
  return includes<PaddedSlab>(pair, pair.half, side, ray, t);
}
bool in_bytes(const BoxedPair& pair, u32 side, const Ray& ray, float t) {
  return includes<PaddedSlab>(pair, pair.byte, side, ray, t);
}

constexpr Test kTests[] = {{"padded", true, in_floats<PaddedSlab>},
                           {"padded, half nodes", true, in_halves},
                           {"padded, byte nodes", true, in_bytes},
                           {"ize", false, in_floats<IzeSlab>},
                           {"plain", false, in_floats<PlainSlab>}};

struct Found {
  u64 pairs = 0, hits = 0;  // of a ray and a triangle
  std::array<u64, std::size(kTests)> misses{};
  std::array<std::string, std::size(kTests)> first{};

  void ask(const BoxedPair& pair, u32 side, const Ray& ray, float t) {
    ++hits;
    for (std::size_t i = 0; i < std::size(kTests); ++i) {
      if (kTests[i].includes(pair, side, ray, t) || misses[i]++ != 0 || !kTests[i].strict) continue;
      first[i] = text_of(accuracy::Failure{
          "t " + accuracy::text_of(t) + " is outside the box", ray, {pair.triangles[side], pair.triangles[1 - side]}});
    }
  }
};

/// The distance, when the triangle is met in the ray's interval.
template <class Intersector>
std::optional<float> hit(const Ray& ray, const Corners& triangle) {
  float t, u, v;
  const bool counts = intersect(Intersector(ray), triangle, t, u, v) && t >= ray.tmin && t <= ray.tmax;
  return counts ? std::optional(t) : std::nullopt;
}

Found ask_random_pairs(u64 wanted, accuracy::Random random) {
  Found found;
  while (found.hits < wanted) {
    const BoxedPair pair = random_pair(random);
    for (u32 i = 0; i < 2 * kRaysOfPair; ++i) {
      const u32 side = i % 2;
      const Ray ray = random_ray(pair, side, random);
      if (!is_valid(ray)) continue;
      ++found.pairs;
      const std::optional<float> t = hit<Watertight>(ray, pair.triangles[side]);
      const std::optional<float> exact_t = hit<Exact>(ray, pair.triangles[side]);
      if (t) found.ask(pair, side, ray, *t);
      if (exact_t && exact_t != t) found.ask(pair, side, ray, *exact_t);
    }
  }
  return found;
}

}  // namespace

void ask_slabs(Run& run) {
  const u64 wanted = run.part_of(1e8);
  const Stopwatch watch;
  const auto all = run_workers(run.settings.threads, [&](u32 worker) {
    return ask_random_pairs(wanted, accuracy::Random(static_cast<u32>(run.seed_of(worker))));
  });
  const double seconds = watch.ms() * 1e-3;
  for (std::size_t i = 0; i < std::size(kTests); ++i) {
    Row row{.part = "slabs", .technique = kTests[i].name, .seconds = seconds, .strict = kTests[i].strict};
    u64 pairs = 0;
    for (const Found& found : all) {
      row.rays += found.hits;
      row.failures += found.misses[i];
      pairs += found.pairs;
      if (row.first_failure.empty()) row.first_failure = found.first[i];
    }
    row.note = "hits of " + std::to_string(pairs) + " pairs ";
    run.table.add(row);
  }
}

}  // namespace raywalk::at_scale
