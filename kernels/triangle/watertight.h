// Watertight ray-triangle test: no ray slips between triangles that share an edge or a vertex, and none meets two.
// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013, with edge functions by Kahan's
// difference of products, whose sign is exact, so that neighbours agree on a shared edge without a double fallback.
#pragma once
#include "kernels/ray.h"
#include "kernels/scene_view.h"

namespace raywalk {

/// A ray sheared so that it runs along +z from the origin; made once a ray.
struct Watertight {
  u32 kx, ky, kz;
  float sx, sy, sz;
  float ox, oy, oz;  // the origin's components kx, ky, kz

  Watertight() = default;
  RW_FN explicit Watertight(const Ray& ray) {
    const Vec3 m = magnitude(ray.d);
    kz = m.x > m.y ? (m.x > m.z ? 0u : 2u) : (m.y > m.z ? 1u : 2u);
    kx = kz == 2u ? 0u : kz + 1u;
    ky = kx == 2u ? 0u : kx + 1u;
    const float dz = ray.d[kz];
    if (dz < 0.0f) {  // keep the winding
      const u32 swap = kx;
      kx = ky;
      ky = swap;
    }
    sx = divide(ray.d[kx], dz);
    sy = divide(ray.d[ky], dz);
    sz = reciprocal(dz);
    ox = ray.o[kx];
    oy = ray.o[ky];
    oz = ray.o[kz];
  }
};

namespace detail {

/// The sign bit of the edge function of p and q, which is zero: the ray runs through the edge. It counts as moved by
/// (e, e^2) for an infinitely small e, so each edge and each vertex belongs to one of the triangles around it.
RW_FN u32 sign_on_edge(float px, float py, float qx, float qy) {
  const bool positive = py > qy || (py == qy && qx > px);
  return positive ? 0u : 0x80000000u;
}

}  // namespace detail

/// Writes t, u, v and returns true when the line of the ray meets the triangle. Of triangles that share an edge or a
/// vertex, the line through it meets as many as if it passed beside it; so at the border of a surface it meets one or
/// none.
/// The caller compares t with the interval. Non-finite triangles and those with two equal vertices are never met, nor
/// are ones whose squared extent is no float (below 1e-19 or above 1e19 across). Three vertices on a line are taken out
/// of a scene when it is packed: rounded, they may enclose an area.
RW_FN bool intersect(const Watertight& ray, const Corners& triangle, float& t, float& u, float& v) {
  // Components are read by address: cheaper than selecting among values.
  const float *a = &triangle.a.x, *b = &triangle.b.x, *c = &triangle.c.x;
  const float az = a[ray.kz] - ray.oz, bz = b[ray.kz] - ray.oz, cz = c[ray.kz] - ray.oz;
  const float ax = fma(-ray.sx, az, a[ray.kx] - ray.ox), ay = fma(-ray.sy, az, a[ray.ky] - ray.oy);
  const float bx = fma(-ray.sx, bz, b[ray.kx] - ray.ox), by = fma(-ray.sy, bz, b[ray.ky] - ray.oy);
  const float cx = fma(-ray.sx, cz, c[ray.kx] - ray.ox), cy = fma(-ray.sy, cz, c[ray.ky] - ray.oy);
  const float wa = difference_of_products(cx, by, cy, bx);
  const float wb = difference_of_products(ax, cy, ay, cx);
  const float wc = difference_of_products(bx, ay, by, ax);
  u32 sa = bits_of(wa), sb = bits_of(wb), sc = bits_of(wc);
  if (wa == 0.0f || wb == 0.0f || wc == 0.0f) {
    sa = wa == 0.0f ? detail::sign_on_edge(cx, cy, bx, by) : sa;
    sb = wb == 0.0f ? detail::sign_on_edge(ax, ay, cx, cy) : sb;
    sc = wc == 0.0f ? detail::sign_on_edge(bx, by, ax, ay) : sc;
  }
  if ((((sa ^ sb) | (sa ^ sc)) & 0x80000000u) != 0) return false;
  const float det = wa + wb + wc;
  if (!(magnitude(det) > 0.0f)) return false;  // also drops NaN
  const float inverse = reciprocal(det);
  u = wb * inverse;
  v = wc * inverse;
  // Weights first: a product of three lengths would leave the range of floats at scales of 1e-13 and 1e13.
  t = fma(wa * inverse, az, fma(u, bz, v * cz)) * ray.sz;
  return is_finite(t);
}

}  // namespace raywalk
