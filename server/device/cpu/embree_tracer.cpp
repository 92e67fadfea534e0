// Primary rays eight at a time; out of line, so that the compiler vectorises the loops over lanes.
#include "server/device/cpu/embree_tracer.h"

#include <algorithm>

namespace raywalk::embree {

void fill_primary(RTCRayHit8& packet, int* valid, const Camera& camera, u32 bx, u32 by, u32 first, const Tile& tile) {
  const Camera c = camera;  // nothing can alias a local
  alignas(32) float x[kPacket], y[kPacket];
  alignas(32) float dx[kPacket], dy[kPacket], dz[kPacket];
  for (u32 i = 0; i < kPacket; ++i) {
    const u32 px = bx + block_x(first + i), py = by + block_y(first + i);
    valid[i] = px < tile.x1 && py < tile.y1 ? -1 : 0;
    x[i] = static_cast<float>(static_cast<i32>(px));
    y[i] = static_cast<float>(static_cast<i32>(py));
  }
  for (u32 i = 0; i < kPacket; ++i) {
    const Vec3 d = primary_direction(c, x[i], y[i]);
    dx[i] = d.x;
    dy[i] = d.y;
    dz[i] = d.z;
  }
  std::copy_n(dx, kPacket, packet.ray.dir_x);
  std::copy_n(dy, kPacket, packet.ray.dir_y);
  std::copy_n(dz, kPacket, packet.ray.dir_z);
  std::fill_n(packet.ray.org_x, kPacket, c.eye.x);
  std::fill_n(packet.ray.org_y, kPacket, c.eye.y);
  std::fill_n(packet.ray.org_z, kPacket, c.eye.z);
  std::fill_n(packet.ray.tnear, kPacket, 0.0f);
  std::fill_n(packet.ray.tfar, kPacket, kMaxFloat);
  std::fill_n(packet.ray.time, kPacket, 0.0f);
  std::fill_n(packet.ray.mask, kPacket, 0xffffffffu);
  std::fill_n(packet.ray.flags, kPacket, 0u);
  std::fill_n(packet.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
}

bool shade(SceneView scene, const RTCRayHit8& packet, Vec3Batch& colors) {
  static_assert(kPacket == kBatch);
  u32 first = kPacket;  // lanes that missed are shaded as copies of it, since a vector has all lanes anyway
  for (u32 i = kPacket; i-- > 0;)
    if (packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) first = i;
  if (first == kPacket) return false;
  HitBatch batch;
  for (u32 i = 0; i < kPacket; ++i) {
    const bool hit = packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    batch.id[i] = hit ? packet.hit.primID[i] : packet.hit.primID[first];
    batch.u[i] = hit ? packet.hit.u[i] : packet.hit.u[first];
    batch.v[i] = hit ? packet.hit.v[i] : packet.hit.v[first];
  }
  std::copy_n(packet.ray.dir_x, kPacket, batch.d.x);
  std::copy_n(packet.ray.dir_y, kPacket, batch.d.y);
  std::copy_n(packet.ray.dir_z, kPacket, batch.d.z);
  unshadowed_batch(scene, batch, colors);
  return true;
}

}  // namespace raywalk::embree
