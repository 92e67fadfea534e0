// Surfaces, spawn offsets, rays.
#include "server/bench/shadow_rays.h"

#include <algorithm>
#include <stdexcept>

#include "server/device/camera.h"
#include "server/device/knobs.h"

namespace raywalk {
ShadowRays shadow_rays(SceneView scene, const FrameJob& job, std::span<const Hit> hits, u64 limit) {
  if (hits.size() != u64{job.width} * job.height) throw std::logic_error("shadow rays of another frame");
  const Camera camera = camera_of(job.camera, job.width, job.height);
  const SpawnOrigin origin_at = spawn_origin_of(knobs_of(job.kernel).spawn);  // the default for an engine
  std::vector<u32> lit;                                                       // pixels with a hit
  for (u32 i = 0; i < hits.size(); ++i) {
    if (hits[i].id < scene.triangle_count()) lit.push_back(i);
  }
  const u64 pairs = lit.size() * scene.light_count(), taken = std::min(pairs, limit);
  ShadowRays out;
  for (u64 i = 0; i < taken; ++i) {
    const u64 pair = i * pairs / taken;
    const u32 pixel = lit[pair / scene.light_count()];
    const Vec3 lamp = scene.lights()[pair % scene.light_count()].position;
    const Ray primary = primary_ray(camera, pixel % job.width, pixel / job.width);
    const Surface surface = surface_at<kFeatureNormals>(scene, hits[pixel], primary.d, 0.0f);
    const Vec3 to_lamp = lamp - surface.position;
    if (!(dot(surface.normal, to_lamp) > 0.0f)) continue;
    const Vec3 origin = origin_at(surface, to_lamp);
    out.rays.push_back({origin, 0.0f, lamp - origin, 1.0f});
    out.origins.push_back(hits[pixel].id);
  }
  return out;
}

}  // namespace raywalk
