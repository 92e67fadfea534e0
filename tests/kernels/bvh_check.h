// Compares the BVH's traversals with the linear loop, bit for bit.
#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "kernels/accel/brute/traverse.h"
#include "kernels/accel/bvh/build.h"
#include "kernels/accel/bvh/while_while.h"
#include "kernels/accel/traversals.h"
#include "kernels/counter.h"
#include "tests/support/meshes.h"

namespace raywalk::test {

inline Hit brute_closest(SceneView scene, const Ray& ray) {
  ClosestHit query(ray);
  NoCounter none;
  brute::traverse(nullptr, scene, ray, query, none);
  return query.best;
}
inline bool brute_any(SceneView scene, const Ray& ray) {
  AnyHit query(ray);
  NoCounter none;
  brute::traverse(nullptr, scene, ray, query, none);
  return query.occluded;
}

inline Hit bvh_closest(const u8* bvh, SceneView scene, const Ray& ray) {
  ClosestHit query(ray);
  NoCounter none;
  bvh::while_while::traverse(bvh, scene, ray, query, none);
  return query.best;
}
inline bool bvh_any(const u8* bvh, SceneView scene, const Ray& ray) {
  AnyHit query(ray);
  NoCounter none;
  bvh::while_while::traverse(bvh, scene, ray, query, none);
  return query.occluded;
}

constexpr u32 kPacket = BvhPacket::kGroup;

/// Up to kPacket rays through the packet traversal; the lanes beyond `count` are not active.
template <class Query>
struct PacketRun {
  Query queries[kPacket];
  Counter counters[kPacket];
  bool active[kPacket];

  PacketRun(const u8* bvh, SceneView scene, const Ray* rays, u32 count) {
    Ray lanes[kPacket] = {};
    for (u32 i = 0; i < kPacket; ++i) {
      active[i] = i < count;
      if (!active[i]) continue;
      lanes[i] = rays[i];
      queries[i] = Query(rays[i]);
    }
    bvh::packet::traverse<Lanes<kPacket>>(bvh, scene, lanes, active, queries, counters);
  }
};

inline bool same(const Hit& a, const Hit& b) {
  return a.id == b.id && bits_of(a.t) == bits_of(b.t) && bits_of(a.u) == bits_of(b.u) && bits_of(a.v) == bits_of(b.v);
}

/// Both traversals and both queries against the linear loop. Returns the number of rays that hit.
inline u32 expect_like_brute(const Mesh& mesh, const std::vector<Ray>& rays, const bvh::Config& config = {}) {
  const Blob scene_blob = make_scene(mesh);
  const SceneView scene = view_of(scene_blob);
  const BuiltStructure built = bvh::build(scene, config);
  const u8* bvh = built.blob.data();
  u32 hits = 0, wrong = 0;
  for (u32 first = 0; first < rays.size(); first += kPacket) {
    const u32 count = std::min(kPacket, static_cast<u32>(rays.size()) - first);
    const auto closest = std::make_unique<PacketRun<ClosestHit>>(bvh, scene, &rays[first], count);
    const auto any = std::make_unique<PacketRun<AnyHit>>(bvh, scene, &rays[first], count);
    for (u32 i = 0; i < count; ++i) {
      const Ray& ray = rays[first + i];
      const Hit expected = brute_closest(scene, ray);
      const bool occluded = expected.id != kMiss;
      hits += occluded;
      wrong += !same(bvh_closest(bvh, scene, ray), expected);
      wrong += !same(closest->queries[i].best, expected);
      wrong += brute_any(scene, ray) != occluded;
      wrong += bvh_any(bvh, scene, ray) != occluded;
      wrong += any->queries[i].occluded != occluded;
    }
  }
  EXPECT_EQ(wrong, 0u) << "of " << rays.size() << " rays, " << hits << " hit";
  return hits;
}

/// Random, edge-aimed, vertex-aimed and axis-parallel rays, `count` of each.
inline std::vector<Ray> all_rays(const Mesh& mesh, u32 count, u32 seed = 1) {
  std::vector<Ray> rays = random_rays(seed, count, bounds_of(mesh));
  for (const auto& more :
       {edge_rays(seed, count, mesh), vertex_rays(seed, count, mesh), axis_rays(seed, count, mesh)}) {
    rays.insert(rays.end(), more.begin(), more.end());
  }
  return rays;
}

}  // namespace raywalk::test
