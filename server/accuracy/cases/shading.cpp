// Shadows at the terminator, glass, mirrors.
#include <cmath>
#include <limits>

#include "kernels/shade/phong.h"
#include "server/accuracy/cases/case_list.h"
#include "server/accuracy/cases/hex.h"
#include "server/accuracy/cases/spawned.h"
#include "server/accuracy/cases/trial.h"

namespace raywalk::accuracy {
namespace {

/// The mesh with one material and the features that it needs.
SceneBlob scene_of_material(const Mesh& mesh, const Material& material, u32 features) {
  Blob blob = make_scene(mesh);
  SceneHeader header = blob.header<SceneHeader>();
  header.features = features;
  std::memcpy(blob.data(), &header, sizeof header);
  slice_of(blob, header.materials)[0] = material;
  return std::make_shared<const Blob>(std::move(blob));
}

void renders_the_same_twice(Exam& exam, const SceneBlob& scene, const CameraPose& camera, const std::string& name) {
  FrameJob job;
  job.structure = exam.build(scene);
  job.camera = camera;
  job.width = job.height = 48;
  job.mode = Mode::whitted;
  job.depth = 8;
  const Frame first = exam.render(job), second = exam.render(job);
  exam.add_rays(u64{job.width} * job.height);
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    if (!is_finite(first.pixels[i]) || first.pixels[i] < 0.0f)
      exam.fail(name + ": pixel component " + std::to_string(i) + " is " + text_of(first.pixels[i]));
    if (bits_of(first.pixels[i]) != bits_of(second.pixels[i]))
      exam.fail(name + ": pixel component " + std::to_string(i) + " differs between two frames");
  }
}

/// Rays inside glass that meet its surface at the critical angle give or take some ulps: refracted along the surface or
/// reflected, and neither meets the surface at once again.
void critical_angle(Exam& exam) {
  const SceneBlob& scene = exam.store().get("slab", [] { return scene_of(quad_grid(2)); });
  const StructureRef structure = exam.build(scene);
  const float critical = std::asin(1.0f / 1.5f);
  std::vector<Ray> incoming;
  for (int ulps = -64; ulps <= 64; ++ulps) {
    const float angle = float_of(bits_of(critical) + static_cast<u32>(ulps));
    for (u32 i = 0; i < 16; ++i) {
      const float round = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / 16.0f;
      const Vec3 d{std::sin(angle) * std::cos(round), std::sin(angle) * std::sin(round), std::cos(angle)};
      incoming.push_back({Vec3{0.1f, 0.2f, 0.0f} - 0.3f * d, 0.0f, d, kFarAway});
    }
  }
  const std::vector<Hit> hits = exam.closest(structure, incoming);
  const SpawnOrigin origin_at = spawn_origin_of(exam.technique());
  std::vector<Ray> outgoing;
  for (std::size_t i = 0; i < incoming.size(); ++i) {
    if (hits[i].id == kMiss) {
      exam.fail([&] { return Failure{"misses the glass", incoming[i], mesh_of(scene)}; });
      continue;
    }
    const Surface surface = surface_at<0>({scene->data()}, hits[i], incoming[i].d, 0.0f);
    Vec3 d{};
    if (!refracted(normalized(incoming[i].d), surface.normal, 1.5f, d)) d = reflected(incoming[i].d, surface.normal);
    if (!is_finite(d) || std::abs(length(d) - 1.0f) > 1e-5f)
      exam.fail([&] { return Failure{"no unit direction behind the surface", incoming[i]}; });
    outgoing.push_back({origin_at(surface, d), 0.0f, d, kFarAway});
  }
  misses(exam, scene, outgoing);
}

}  // namespace

void terminator(Exam& exam) {
  const Mesh& mesh = exam.store().get("mesh", [] { return icosphere(1, 2.0f); });
  const SceneBlob& scene = exam.store().get("scene", [&] { return scene_of(mesh); });
  const StructureRef structure = exam.build(scene);
  const Vec3 light = normalized({0.3f, 1.0f, 0.2f});
  Random random = exam.random(1);
  std::vector<Ray> primary, shadow;
  for (u32 i = 0; i < exam.count(50'000); ++i)
    primary.push_back(ray_towards(random.direction() * 6.0f, random.direction()));
  const std::vector<Hit> hits = exam.closest(structure, primary);
  const SpawnOrigin origin_at = spawn_origin_of(exam.technique());
  std::vector<u8> lit;
  for (std::size_t i = 0; i < primary.size(); ++i) {
    if (hits[i].id == kMiss) continue;
    const Surface surface = surface_at<0>({scene->data()}, hits[i], primary[i].d, 0.0f);
    const float facing = dot(surface.geometric_normal, light);
    // What the smooth normal calls lit beyond the terminator lies in the sphere's own shadow.
    if (std::abs(facing) < 1e-4f || dot(normalized(surface.position), light) < 0.0f) continue;
    shadow.push_back({origin_at(surface, light), 0.0f, light, kMaxFloat});
    lit.push_back(facing > 0.0f ? 1 : 0);
  }
  const std::vector<u8> dark = exam.occluded(structure, shadow);
  exam.add_rays(shadow.size());
  for (std::size_t i = 0; i < shadow.size(); ++i) {
    if (dark[i] != lit[i]) continue;
    exam.fail([&] { return Failure{lit[i] != 0 ? "shadow on a lit facet" : "light through the sphere", shadow[i]}; });
  }
}

void glass_and_mirrors(Exam& exam) {
  critical_angle(exam);
  const SceneBlob& glass = exam.store().get("glass", [] {
    return scene_of_material(icosphere(2, 2.0f),
                             {.specular = {1, 1, 1},
                              .reflection = {0.1f, 0.1f, 0.1f},
                              .transmission = {0.9f, 0.9f, 0.9f},
                              .shininess = 20,
                              .ior = 1.5f},
                             kFeatureSpecular | kFeatureReflection | kFeatureRefraction);
  });
  const SceneBlob& mirrors = exam.store().get("mirrors", [] {
    Mesh mesh = quad_grid(2, 0, -1.0f);
    append(mesh, quad_grid(2, 0, 1.0f));
    return scene_of_material(mesh, {.diffuse = {0.2f, 0.2f, 0.2f}, .reflection = {0.9f, 0.9f, 0.9f}},
                             kFeatureReflection);
  });
  renders_the_same_twice(exam, glass, {.eye = {0.1f, 0.2f, 0.3f}, .target = {1, 0.5f, -1}}, "inside glass");
  renders_the_same_twice(exam, glass, {.eye = {0, 0, 6}, .target = {0, 0, 0}}, "glass from outside");
  renders_the_same_twice(exam, mirrors, {.eye = {0, 0, 0}, .target = {1, 0, 0}}, "between mirrors");
}

}  // namespace raywalk::accuracy
