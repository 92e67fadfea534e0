// Tracers: a traversal bound to a scene and its structure, as shading and the ray kernels use it. Invalid rays miss
// here, so that no traversal ever meets one.
#pragma once
#include "kernels/counter.h"
#include "kernels/lanes.h"
#include "kernels/query.h"

namespace raywalk {

/// Rays one by one.
template <class Traversal, class CounterT, class Knobs = StrictKnobs>
struct SingleTracer {
  static constexpr u32 kLocal = 1;
  SceneView scene;
  const u8* blob;
  CounterT counter{};
  u32 stack_entries = kStackEntries;

  RW_FN void closest(const Ray* rays, const bool* active, Hit* hits) {
    if (!active[0]) return;
    counter.ray();
    if (!is_valid(rays[0])) {
      hits[0] = miss_of(rays[0]);
      return;
    }
    ClosestHitBy<Knobs> query(rays[0]);
    query.stack_entries = stack_entries;
    Traversal::traverse(blob, scene, rays[0], query, counter);
    hits[0] = query.best;
  }
  RW_FN void occluded(const Ray* rays, const bool* active, bool* out) {
    out[0] = false;
    if (!active[0]) return;
    counter.ray();
    if (!is_valid(rays[0])) return;
    AnyHitBy<Knobs> query(rays[0]);
    query.stack_entries = stack_entries;
    Traversal::traverse(blob, scene, rays[0], query, counter);
    out[0] = query.occluded;
  }
  RW_FN bool any(const bool* flags) const { return flags[0]; }
};

/// Traversal::kGroup rays together.
template <class Traversal, class CounterT, class Knobs = StrictKnobs>
struct GroupTracer {
  using Group = Lanes<Traversal::kGroup>;
  static constexpr u32 kLocal = Group::kLocal;
  SceneView scene;
  const u8* blob;
  CounterT counter[kLocal]{};

  RW_FN void closest(const Ray* rays, const bool* active, Hit* hits) {
    ClosestHitBy<Knobs> queries[kLocal];
    bool valid[kLocal];
    begin(rays, active, valid, queries);
    Traversal::template traverse<Group>(blob, scene, rays, valid, queries, counter);
    for (u32 i = 0; i < kLocal; ++i)
      if (active[i]) hits[i] = valid[i] ? queries[i].best : miss_of(rays[i]);
  }
  RW_FN void occluded(const Ray* rays, const bool* active, bool* out) {
    AnyHitBy<Knobs> queries[kLocal];
    bool valid[kLocal];
    begin(rays, active, valid, queries);
    Traversal::template traverse<Group>(blob, scene, rays, valid, queries, counter);
    for (u32 i = 0; i < kLocal; ++i) out[i] = valid[i] && queries[i].occluded;
  }
  RW_FN bool any(const bool* flags) const { return Group::any(flags); }

 private:
  template <class Query>
  RW_FN void begin(const Ray* rays, const bool* active, bool* valid, Query* queries) {
    for (u32 i = 0; i < kLocal; ++i) {
      valid[i] = active[i] && is_valid(rays[i]);
      if (active[i]) counter[i].ray();
      if (valid[i]) queries[i] = Query(rays[i]);
    }
  }
};

}  // namespace raywalk
