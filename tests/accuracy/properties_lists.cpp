// Properties of one scene: lists of rays in another order, other intervals, the other query, brute force.
#include <cmath>

#include "server/accuracy/cases/hex.h"
#include "server/accuracy/cases/placed.h"
#include "server/device/knobs.h"
#include "tests/accuracy/properties.h"

namespace raywalk::accuracy {
namespace {

constexpr u32 kRays = 150;  // of each kind

Vec3 snapped(Vec3 p) {
  const auto on_grid = [](float a) { return std::nearbyint(a * 0x1p12f) * 0x1p-12f; };
  return {on_grid(p.x), on_grid(p.y), on_grid(p.z)};
}

Shape sealed_shape(std::string name, const Mesh& mesh, u32 seed, bool snap) {
  Shape shape{std::move(name), mesh, {}, true};
  Random random(seed);
  for (u32 i = 0; i < 3 * kRays; ++i) {
    const Vec3 o = random.in_box({-0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, 0.4f}), from = snap ? snapped(o) : o;
    const Corners& t = mesh[random.below(static_cast<u32>(mesh.size()))];
    const u32 place = random.below(3);
    const float along = random.below(2) != 0 ? 0.5f : random.uniform();
    shape.rays.push_back(i % 3 == 0   ? Ray{from, 0.0f, random.direction(), kFarAway}
                         : i % 3 == 1 ? ray_to_edge(from, t, place, along)
                                      : ray_to_vertex(from, t, place));
  }
  return shape;
}

Shape soup_shape() {
  Shape shape{"soup", random_soup(21, 600, 0.4f), {}, false};
  for (const auto& rays : {random_rays(22, kRays, bounds_of(shape.mesh)), edge_rays(23, kRays, shape.mesh),
                           vertex_rays(24, kRays, shape.mesh)})
    shape.rays.insert(shape.rays.end(), rays.begin(), rays.end());
  return shape;
}

std::vector<Shape> numbered(std::vector<Shape> all) {
  for (Shape& shape : all)
    for (u32 i = 0; i < shape.mesh.size(); ++i) shape.mesh[i].id = i;
  return all;
}

/// Each answer is the expected one, bit for bit.
void expect_same(Exam& exam, const Shape& shape, const std::vector<Ray>& rays, const std::vector<Hit>& hits,
                 const std::vector<Hit>& expected, const std::string& what) {
  exam.add_rays(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (same_bits(hits[i], expected[i])) continue;
    exam.fail([&] {
      return Failure{shape.name + ", " + what + ": given " + text_of(hits[i]) + ", expected " + text_of(expected[i]),
                     rays[i], ring_around(shape.mesh, {hits[i].id, expected[i].id})};
    });
  }
}

/// Packets test the triangles of a box for all their rays, also for those that pass the box by.
bool depends_on_neighbours(Exam& exam) {
  if (exam.technique().traversal != "packet" || hits_stay_in_boxes(exam)) return false;
  exam.does_not_apply("a ray of a packet may meet a triangle outside its box in the box of a neighbour");
  return true;
}

bool is_embree(const Exam& exam) {
  return exam.technique().structure == "embree";
}

/// Ends of intervals around a hit, or anywhere for a miss.
std::vector<float> cuts_of(const Hit& hit, Random& random) {
  if (hit.id == kMiss) return {random.uniform(0.0f, 4.0f)};
  return {hit.t, std::nextafter(hit.t, -kMaxFloat), std::nextafter(hit.t, kMaxFloat),
          hit.t * random.uniform(0.0f, 2.0f)};
}

}  // namespace

const std::vector<Shape>& shapes() {
  // The box lies on a grid with its rays, which meet its edges and vertices exactly.
  static const std::vector<Shape> all = numbered({sealed_shape("sphere", icosphere(3), 11, false),
                                                  sealed_shape("box", subdivided_box(8), 12, true), soup_shape()});
  return all;
}

const SceneBlob& scene_of(Exam& exam, const Shape& shape) {
  return exam.store().get(shape.name, [&] { return scene_of(shape.mesh); });
}

std::string_view intersector_of(const Technique& technique) {
  const auto knob = technique.kernel.find("intersector");
  return knob == technique.kernel.end() ? "" : intersector_rows().at(static_cast<std::size_t>(knob->second)).name;
}

bool hits_stay_in_boxes(const Exam& exam) {
  const std::string_view test = intersector_of(exam.technique());
  return exam.strict() || test == "double" || test == "baldwin-weber";
}

bool may_lose_hits(Exam& exam) {
  if (exam.is_brute() || hits_stay_in_boxes(exam)) return false;
  exam.does_not_apply("a hit may lie outside its box, and what is found then depends on the boxes");
  return true;
}

/// The same list gives the same bits when it is asked again, and of a structure that was built again. Embree's build is
/// not ours to promise.
void repeated_runs(Exam& exam) {
  for (const Shape& shape : shapes()) {
    const StructureRef structure = exam.build(scene_of(exam, shape));
    const std::vector<Hit> hits = exam.closest(structure, shape.rays);
    expect_same(exam, shape, shape.rays, exam.closest(structure, shape.rays), hits, "asked again");
    if (is_embree(exam)) continue;
    expect_same(exam, shape, shape.rays, exam.closest_among(shape.mesh, shape.rays), hits, "built again");
  }
}

/// A ray's bits are the same alone, in the list, and in the list from back to front.
void alone_or_in_a_list(Exam& exam) {
  if (is_embree(exam)) return exam.does_not_apply("at an edge it depends on the packet which triangle is given");
  if (depends_on_neighbours(exam)) return;
  for (const Shape& shape : shapes()) {
    const StructureRef structure = exam.build(scene_of(exam, shape));
    const std::vector<Hit> hits = exam.closest(structure, shape.rays);
    std::vector<Hit> backwards = exam.closest(structure, {shape.rays.rbegin(), shape.rays.rend()});
    expect_same(exam, shape, shape.rays, {backwards.rbegin(), backwards.rend()}, hits, "from back to front");
    for (std::size_t i = 0; i < shape.rays.size(); i += 7)
      expect_same(exam, shape, {shape.rays[i]}, exam.closest(structure, {shape.rays[i]}), {hits[i]}, "alone");
  }
}

/// Every traversal gives the bits of brute force with the same triangle test.
void as_by_brute_force(Exam& exam) {
  if (may_lose_hits(exam)) return;
  for (const Shape& shape : shapes()) {
    const SceneBlob& scene = scene_of(exam, shape);
    expect_same(exam, shape, shape.rays, exam.closest(exam.build(scene), shape.rays),
                exam.brute_force(scene, shape.rays), "brute force");
  }
}

/// A ray is occluded exactly when it has a closest hit, whatever its interval; Embree, which treats a hit at the very
/// end otherwise in both queries, is asked of whole rays only.
void occluded_when_hit(Exam& exam) {
  if (depends_on_neighbours(exam)) return;
  Random random = exam.random(1);
  for (const Shape& shape : shapes()) {
    const StructureRef structure = exam.build(scene_of(exam, shape));
    const std::vector<Hit> whole = exam.closest(structure, shape.rays);
    std::vector<Ray> rays = shape.rays;
    for (std::size_t i = 0; i < whole.size() && !is_embree(exam); ++i) {
      for (const float cut : cuts_of(whole[i], random)) {
        rays.push_back(shape.rays[i]);
        (random.below(2) != 0 ? rays.back().tmin : rays.back().tmax) = cut;
      }
    }
    const std::vector<Hit> hits = exam.closest(structure, rays);
    const std::vector<u8> flags = exam.occluded(structure, rays);
    exam.add_rays(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if ((hits[i].id != kMiss) == (flags[i] != 0)) continue;
      exam.fail([&] {
        return Failure{shape.name + ": occluded is " + std::to_string(flags[i]) + ", closest " + text_of(hits[i]),
                       rays[i], ring_around(shape.mesh, {hits[i].id})};
      });
    }
  }
}

/// An interval cut in two at any t gives the bits of the whole one: those of the first part if that is met, and then
/// inside it, else those of the second.
void split_interval(Exam& exam) {
  if (may_lose_hits(exam)) return;
  Random random = exam.random(1);
  for (const Shape& shape : shapes()) {
    const StructureRef structure = exam.build(scene_of(exam, shape));
    const std::vector<Hit> whole = exam.closest(structure, shape.rays);
    std::vector<Ray> first, second;
    std::vector<Hit> expected;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      for (const float cut : cuts_of(whole[i], random)) {
        first.push_back(shape.rays[i]);
        first.back().tmax = cut;
        second.push_back(shape.rays[i]);
        second.back().tmin = cut;
        expected.push_back(whole[i]);
      }
    }
    std::vector<Hit> joined = exam.closest(structure, second);
    const std::vector<Hit> before = exam.closest(structure, first);
    for (std::size_t i = 0; i < joined.size(); ++i) {
      if (before[i].id == kMiss) continue;
      joined[i] = before[i];
      if (before[i].t > first[i].tmax) exam.fail(shape.name + ": beyond the interval, " + text_of(before[i]));
    }
    expect_same(exam, shape, first, joined, expected, "cut in two");
  }
}

}  // namespace raywalk::accuracy
