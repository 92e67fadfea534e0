// Rays from inside a closed mesh at its edges and vertices: each meets exactly one triangle.
#include "server/accuracy/cases/case_list.h"
#include "server/accuracy/cases/placed.h"

namespace raywalk::accuracy {
namespace {

enum class Aim { edges, vertices };

constexpr u32 kJudged = 400;  // rays of a mesh that rounding has folded: the oracle takes its time

Ray aimed_ray(Aim aim, Vec3 from, const Mesh& mesh, Random& random) {
  const Corners& t = mesh[random.below(static_cast<u32>(mesh.size()))];
  const u32 place = random.below(3);
  return aim == Aim::vertices ? ray_to_vertex(from, t, place) : ray_to_edge(from, t, place, random.uniform());
}

std::vector<Ray> aimed_rays(Aim aim, const Mesh& mesh, const std::vector<Vec3>& from, u32 count, Random random) {
  std::vector<Ray> rays;
  rays.reserve(count);
  while (rays.size() < count) {
    const Ray ray = aimed_ray(aim, from[random.below(static_cast<u32>(from.size()))], mesh, random);
    if (is_valid(ray)) rays.push_back(ray);
  }
  return rays;
}

void aimed_from_inside(Exam& exam, Aim aim) {
  const std::vector<Placed>& meshes = exam.store().get("meshes", [&] { return placed_meshes(exam.random(0)); });
  const u32 count = exam.own_count(1'000'000 / meshes.size());
  for (u32 i = 0; i < meshes.size(); ++i) {
    const Placed& mesh = meshes[i];
    if (!mesh.inside.empty()) {
      meets(exam, mesh.scene, aimed_rays(aim, mesh.mesh, mesh.inside, count, exam.random(i + 1)));
      continue;
    }
    judge(exam, *exam.store().get("folded " + mesh.name, [&] {
      return make_trial(mesh.name, mesh.mesh,
                        aimed_rays(aim, mesh.mesh, {mesh.centre},
                                   std::min(exam.count(1'000'000 / meshes.size()), kJudged), exam.random(i + 1)));
    }));
  }
}

}  // namespace

void aimed_at_edges(Exam& exam) {
  aimed_from_inside(exam, Aim::edges);
}

void aimed_at_vertices(Exam& exam) {
  aimed_from_inside(exam, Aim::vertices);
}

void spiky_sphere(Exam& exam) {
  const Placed& sphere = exam.store().get(
      "sphere", [&] { return placed("spiky sphere", spiky_mesh(exam.random(0)), 1.0f, 0.0f, 0.05f, exam.random(1)); });
  const u32 count = exam.own_count(100'000);
  Random random = exam.random(2);
  std::vector<Ray> rays = aimed_rays(Aim::vertices, sphere.mesh, sphere.inside, count, exam.random(3));
  for (u32 i = 0; i < count; ++i) {
    const Vec3 from = sphere.inside[random.below(static_cast<u32>(sphere.inside.size()))];
    rays.push_back({from, 0.0f, random.direction(), kFarAway});
  }
  meets(exam, sphere.scene, rays);
}

}  // namespace raywalk::accuracy
