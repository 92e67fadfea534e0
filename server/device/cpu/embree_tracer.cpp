// Primary rays and their colours, lanes side by side; out of line, so that the compiler vectorises the loops over
// lanes.
#include "server/device/cpu/embree_tracer.h"

#include <algorithm>

namespace raywalk::embree {

template <u32 N>
void fill_primary(typename Packet<N>::RayHits& packet, int* valid, const Camera& camera, u32 bx, u32 by, u32 first,
                  const Tile& tile) {
  const Camera c = camera;  // nothing can alias a local
  alignas(64) float x[N], y[N];
  alignas(64) float dx[N], dy[N], dz[N];
  for (u32 i = 0; i < N; ++i) {
    const u32 px = bx + block_x(first + i), py = by + block_y(first + i);
    valid[i] = px < tile.x1 && py < tile.y1 ? -1 : 0;
    x[i] = static_cast<float>(static_cast<i32>(px));
    y[i] = static_cast<float>(static_cast<i32>(py));
  }
  for (u32 i = 0; i < N; ++i) {
    const Vec3 d = primary_direction(c, x[i], y[i]);
    dx[i] = d.x;
    dy[i] = d.y;
    dz[i] = d.z;
  }
  std::copy_n(dx, N, packet.ray.dir_x);
  std::copy_n(dy, N, packet.ray.dir_y);
  std::copy_n(dz, N, packet.ray.dir_z);
  std::fill_n(packet.ray.org_x, N, c.eye.x);
  std::fill_n(packet.ray.org_y, N, c.eye.y);
  std::fill_n(packet.ray.org_z, N, c.eye.z);
  std::fill_n(packet.ray.tnear, N, 0.0f);
  std::fill_n(packet.ray.tfar, N, kMaxFloat);
  std::fill_n(packet.ray.time, N, 0.0f);
  std::fill_n(packet.ray.mask, N, 0xffffffffu);
  std::fill_n(packet.ray.flags, N, 0u);
  std::fill_n(packet.hit.geomID, N, RTC_INVALID_GEOMETRY_ID);
}

template <u32 N>
bool shade(SceneView scene, const typename Packet<N>::RayHits& packet, u32 first, float spread, u32 lights,
           Vec3Batch& colors) {
  u32 some = N;  // lanes that missed are shaded as copies of this one, since a vector has all lanes anyway
  for (u32 i = first + kBatch; i-- > first;)
    if (packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) some = i;
  if (some == N) return false;
  HitBatch batch;
  for (u32 i = 0; i < kBatch; ++i) {
    const u32 lane = packet.hit.geomID[first + i] != RTC_INVALID_GEOMETRY_ID ? first + i : some;
    batch.id[i] = packet.hit.primID[lane];
    batch.t[i] = packet.ray.tfar[lane];
    batch.u[i] = packet.hit.u[lane];
    batch.v[i] = packet.hit.v[lane];
  }
  std::copy_n(packet.ray.dir_x + first, kBatch, batch.d.x);
  std::copy_n(packet.ray.dir_y + first, kBatch, batch.d.y);
  std::copy_n(packet.ray.dir_z + first, kBatch, batch.d.z);
  unshadowed_batch(scene, batch, spread, lights, colors);
  return true;
}

template void fill_primary<8>(RTCRayHit8&, int*, const Camera&, u32, u32, u32, const Tile&);
template void fill_primary<16>(RTCRayHit16&, int*, const Camera&, u32, u32, u32, const Tile&);
template bool shade<8>(SceneView, const RTCRayHit8&, u32, float, u32, Vec3Batch&);
template bool shade<16>(SceneView, const RTCRayHit16&, u32, float, u32, Vec3Batch&);

}  // namespace raywalk::embree
