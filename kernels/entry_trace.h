// Host only: traversals compiled for the CPU, once for each pair of triangle test and box test. A file
// entry_trace_*.cpp holds those of one structure, so that they compile side by side.
#pragma once
#include <algorithm>
#include <iterator>
#include <type_traits>

#include "kernels/accel/traversals.h"
#include "kernels/entry_cpu.h"
#include "kernels/tracer.h"

namespace raywalk {

/// Traces rays of which `active` ones count; others are neither read nor answered. Work is added to `counts`, one a
/// ray, where the functions count.
struct TraceFunctions {
  void (*closest)(const TraceTarget& target, const Ray* rays, const bool* active, u64 count, Hit* hits, Counts* counts);
  void (*occluded)(const TraceTarget& target, const Ray* rays, const bool* active, u64 count, bool* occluded,
                   Counts* counts);
};

#define RW_COUNT_ROW(type, name, help) +1
constexpr u32 kIntersectors = 0 RW_INTERSECTORS(RW_COUNT_ROW);
constexpr u32 kSlabTests = 0 RW_SLAB_TESTS(RW_COUNT_ROW);
constexpr u32 kNodeFormats = 0 RW_NODE_FORMATS(RW_COUNT_ROW);
#undef RW_COUNT_ROW

/// All that a traversal is compiled for. Nodes that are no floats go with the default box test alone, so that not too
/// much is compiled; a traversal without nodes takes every format for the default one.
struct TraceTable {
  struct Functions {
    TraceFunctions plain, counting;
  };
  Functions functions[kNodeFormats][kIntersectors][kSlabTests];
};

/// Of a type of RW_TRAVERSALS.
template <class Traversal>
const TraceTable& trace_table();

namespace detail {

template <class Traversal, class KnobsT, class CounterT>
using TracerOf = std::conditional_t<Traversal::kGroup == 1, SingleTracer<Traversal, CounterT, KnobsT>,
                                    GroupTracer<Traversal, CounterT, KnobsT>>;

/// work(tracer, first ray) for each group of rays of which one is active.
template <class Traversal, class KnobsT, class CounterT, class Work>
void for_active_groups(const TraceTarget& target, const bool* active, u64 count, Counts* counts, Work work) {
  using Tracer = TracerOf<Traversal, KnobsT, CounterT>;
  constexpr u32 kLocal = Tracer::kLocal;
  for (u64 first = 0; first < count; first += kLocal) {
    bool some = false;
    for (u32 i = 0; i < kLocal; ++i) some |= active[first + i];
    if (!some) continue;
    Tracer tracer{target.scene, static_cast<const u8*>(target.structure)};
    if constexpr (kLocal == 1) tracer.stack_entries = target.knobs.stack_entries;
    work(tracer, first);
    if constexpr (std::is_same_v<CounterT, Counter>) {
      for (u32 i = 0; i < kLocal; ++i) {
        if constexpr (kLocal == 1) {
          counts[first] += tracer.counter.counts;
        } else {
          counts[first + i] += tracer.counter[i].counts;
        }
      }
    }
  }
}

template <class Traversal, class KnobsT, class CounterT>
constexpr TraceFunctions trace_functions() {
  return {
      [](const TraceTarget& target, const Ray* rays, const bool* active, u64 count, Hit* hits, Counts* counts) {
        for_active_groups<Traversal, KnobsT, CounterT>(target, active, count, counts, [&](auto& tracer, u64 first) {
          tracer.closest(rays + first, active + first, hits + first);
        });
      },
      [](const TraceTarget& target, const Ray* rays, const bool* active, u64 count, bool* occluded, Counts* counts) {
        for_active_groups<Traversal, KnobsT, CounterT>(target, active, count, counts, [&](auto& tracer, u64 first) {
          tracer.occluded(rays + first, active + first, occluded + first);
        });
      }};
}

/// A traversal without boxes takes every box test for the default one.
template <class Traversal, class Nodes, class Intersector, class Slab>
constexpr TraceTable::Functions functions() {
  constexpr bool kBoxes = (Traversal::kKnobs & kKnobSlab) != 0 && std::is_same_v<Nodes, StrictKnobs::Nodes>;
  using Used = TraceKnobs<Intersector, std::conditional_t<kBoxes, Slab, StrictKnobs::Slab>, Nodes>;
  return {trace_functions<Traversal, Used, NoCounter>(), trace_functions<Traversal, Used, Counter>()};
}

template <class Traversal, class Nodes>
void fill(TraceTable& table, u32 format) {
  using Used = std::conditional_t<(Traversal::kKnobs & kKnobSlab) != 0, Nodes, StrictKnobs::Nodes>;
  u32 intersector = 0;
#define RW_FILL_SLAB(type, name, help) functions<Traversal, Used, Intersector, type>(),
#define RW_FILL(type, name, help)                                                      \
  {                                                                                    \
    using Intersector = type;                                                          \
    const TraceTable::Functions row[] = {RW_SLAB_TESTS(RW_FILL_SLAB)};                 \
    std::copy(std::begin(row), std::end(row), table.functions[format][intersector++]); \
  }
  RW_INTERSECTORS(RW_FILL)
#undef RW_FILL
#undef RW_FILL_SLAB
}

template <class Traversal>
TraceTable make_trace_table() {
  TraceTable table{};
  u32 format = 0;
#define RW_FILL(type, name, help) fill<Traversal, type>(table, format++);
  RW_NODE_FORMATS(RW_FILL)
#undef RW_FILL
  return table;
}

}  // namespace detail

/// Defines trace_table<type>() in a file of its own.
#define RW_DEFINE_TRACE_TABLE(type)                                   \
  template <>                                                         \
  const TraceTable& trace_table<type>() {                             \
    static const TraceTable table = detail::make_trace_table<type>(); \
    return table;                                                     \
  }

}  // namespace raywalk
