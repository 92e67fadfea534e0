// The lists of rays of a sweep, made on the host: the same scene, number and seed give the same rays.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "server/accuracy/sweep/spec.h"
#include "server/device/device.h"
#include "server/device/knobs.h"

namespace raywalk::accuracy {

struct RayList {
  RayKind kind = RayKind::primary;
  std::vector<Ray> rays;
  std::vector<u32> own;  // triangle that each ray leaves or is aimed at; empty for primary and random

  RayQuery query() const { return kind == RayKind::shadow ? RayQuery::any : RayQuery::closest; }
};

/// Frames of the walkthrough that primary rays are taken from.
constexpr u32 kPrimaryFrames = 4;
/// Side in pixels of these frames when about `rays` are wanted; a whole number of blocks.
u32 primary_side(u64 rays);

class RayMaker {
 public:
  using Closest = std::function<std::vector<Hit>(const std::vector<Ray>& rays)>;

  /// `closest` finds what primary rays hit, with barycentrics; it is asked when spawned rays are wanted first.
  RayMaker(const LoadedScene& scene, u64 rays, u64 seed, Closest closest);

  /// `spawn` is a name of kernels/knobs.h, used for spawned rays alone. Lists are near `rays` long; those of spawned
  /// rays are shorter where few pixels show something. Empty when the scene has nothing to take them from.
  RayList make(RayKind kind, const std::string& spawn);
  /// Rays beside the scene that meet nothing.
  std::vector<Ray> misses() const;

 private:
  struct Origin {  // of spawned rays
    Hit hit;
    Vec3 d;  // of the ray that hit
  };
  std::vector<Ray> primary(u64 rays) const;
  std::vector<Origin> hits_of(const std::vector<Ray>& rays) const;
  const std::vector<Origin>& origins();
  RayList spawned(RayKind kind, SpawnOrigin origin_at);
  std::vector<Ray> random() const;
  RayList aimed(RayKind kind) const;

  const LoadedScene& scene_;
  SceneView view_;
  u64 rays_, seed_;
  Closest closest_;
  std::vector<Origin> origins_;
};

/// The same rays with what makes a ray invalid in turn: no direction, NaN and infinity in each field.
std::vector<Ray> made_invalid(std::vector<Ray> rays);

}  // namespace raywalk::accuracy
