// Loops over eight lanes that the compiler vectorises; kept out of line, since it gives that up once they are inlined.
#include "kernels/shade/direct_batch.h"

namespace raywalk {
namespace {

/// Where the hits of a batch lie.
struct SurfaceBatch {
  Vec3Batch position, normal;
  u32 material[kBatch];
};

constexpr Vec3 kWhite{1, 1, 1};

template <bool kNormals>
void surfaces_of(SceneView scene, const HitBatch& batch, SurfaceBatch& surfaces) {
  // Locals that nothing else can alias, or the loops stay scalar.
  const HitBatch hits = batch;
  Vec3Batch a, b, c, interpolated, position, normal;
  for (u32 i = 0; i < kBatch; ++i) {
    const Corners& t = scene.corners()[hits.id[i]];
    const TriangleIndices& indices = scene.triangles()[hits.id[i]];
    a.set(i, t.a);
    b.set(i, t.b);
    c.set(i, t.c);
    if (kNormals) interpolated.set(i, interpolated_normal(scene, indices, hits.u[i], hits.v[i]));
    surfaces.material[i] = indices.material;
  }
  for (u32 i = 0; i < kBatch; ++i) {
    const Surface s = surface_of(a.get(i), b.get(i), c.get(i), hits.u[i], hits.v[i],
                                 kNormals ? interpolated.get(i) : Vec3{0, 0, 0}, hits.d.get(i), 0);
    position.set(i, s.position);
    normal.set(i, s.normal);
  }
  surfaces.position = position;
  surfaces.normal = normal;
}

/// Adds up the first `lights` lamps; `terms_at(i)` are the material's terms for lane i.
template <class TermsAt>
void light_batch(SceneView scene, const SurfaceBatch& surfaces, const Vec3Batch& directions, u32 lights,
                 TermsAt terms_at, Vec3Batch& colors) {
  const SurfaceBatch s = surfaces;
  const Vec3Batch d = directions;
  Vec3Batch sum = colors;
  for (u32 l = 0; l < lights; ++l) {
    const Light light = scene.lights()[l];
    for (u32 i = 0; i < kBatch; ++i) {
      const Vec3 lit = phong<true>(terms_at(i), light.intensity, s.normal.get(i),
                                   normalized(light.position - s.position.get(i)), d.get(i));
      sum.set(i, sum.get(i) + lit);
    }
  }
  colors = sum;
}

}  // namespace

void unshadowed_batch(SceneView scene, const HitBatch& batch, float spread, u32 lights, Vec3Batch& colors) {
  SurfaceBatch surfaces;
  if (scene.header().normals.count != 0) {
    surfaces_of<true>(scene, batch, surfaces);
  } else {
    surfaces_of<false>(scene, batch, surfaces);
  }
  bool same = scene.materials()[surfaces.material[0]].texture == kNoTexture;
  for (u32 i = 1; i < kBatch; ++i) same &= surfaces.material[i] == surfaces.material[0];
  if (same) {  // most batches: the terms stay in registers
    const Vec3 start = unlit<0>(scene, surfaces.material[0], kWhite);
    for (u32 i = 0; i < kBatch; ++i) colors.set(i, start);
    const PhongTerms terms = phong_terms<0>(scene, surfaces.material[0], kWhite);
    light_batch(
        scene, surfaces, batch.d, lights, [&](u32) { return terms; }, colors);
    return;
  }
  Vec3Batch diffuse, specular;
  alignas(32) float shininess[kBatch];
  for (u32 i = 0; i < kBatch; ++i) {
    const u32 material = surfaces.material[i];
    const Vec3 tint = tint_at(scene, scene.corners()[batch.id[i]], scene.triangles()[batch.id[i]], batch.u[i],
                              batch.v[i], batch.d.get(i), spread * batch.t[i]);
    colors.set(i, unlit<kAllFeatures>(scene, material, tint));
    const PhongTerms terms = phong_terms<kAllFeatures>(scene, material, tint);
    diffuse.set(i, terms.diffuse);
    specular.set(i, terms.specular);
    shininess[i] = terms.shininess;
  }
  light_batch(
      scene, surfaces, batch.d, lights,
      [&](u32 i) {
        return PhongTerms{diffuse.get(i), specular.get(i), shininess[i]};
      },
      colors);
}

}  // namespace raywalk
