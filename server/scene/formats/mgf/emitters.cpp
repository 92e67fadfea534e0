// Grouping emitters, and finding a place for their light where they do not stand in its way.
#include "server/scene/formats/mgf/emitters.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace raywalk {
namespace {

using glm::dvec3;

constexpr size_t kMostLights = 16;
constexpr size_t kMostGroups = 128;  // that are kept apart while reading
constexpr double kTouching = 0.02;   // of their size
constexpr double kTotalIntensity = 1.0;

dvec3 wide(Vec3 v) {
  return {v.x, v.y, v.z};
}

struct Corners3 {
  dvec3 a, b, c;
};

Corners3 corners_of(const Scene& scene, size_t triangle) {
  const TriangleIndices t = scene.triangles[triangle];
  return {wide(scene.positions[t.a]), wide(scene.positions[t.b]), wide(scene.positions[t.c])};
}

/// How far along the ray the triangle is; infinity if it misses.
double distance_to(const Corners3& t, dvec3 origin, dvec3 direction) {
  constexpr double kMiss = std::numeric_limits<double>::infinity();
  const dvec3 ab = t.b - t.a, ac = t.c - t.a, p = glm::cross(direction, ac), from_a = origin - t.a;
  const double determinant = glm::dot(ab, p);
  if (determinant == 0.0) return kMiss;
  const dvec3 q = glm::cross(from_a, ab);
  const double u = glm::dot(from_a, p) / determinant, v = glm::dot(direction, q) / determinant;
  const double distance = glm::dot(ac, q) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 ? distance : kMiss;
}

bool touch(const Extent& a, const Extent& b) {
  const double slack = kTouching * std::max(a.diagonal(), b.diagonal());
  for (int axis = 0; axis < 3; ++axis) {
    if (a.lo[axis] > b.hi[axis] + slack || b.lo[axis] > a.hi[axis] + slack) return false;
  }
  return true;
}

}  // namespace

void Extent::add(dvec3 point) {
  lo = glm::min(lo, point);
  hi = glm::max(hi, point);
}

void Extent::add(const Extent& other) {
  lo = glm::min(lo, other.lo);
  hi = glm::max(hi, other.hi);
}

double Extent::diagonal() const {
  return glm::length(hi - lo);
}

void MgfEmitters::add(const Emitter& emitter, const Scene& scene) {
  Group fresh{.object = emitter.object, .two_sided = emitter.two_sided, .extent = {}, .parts = {emitter}};
  for (size_t i = 0; i < emitter.triangles; ++i) {
    const Corners3 t = corners_of(scene, emitter.first_triangle + i);
    const dvec3 turn = 0.5 * glm::cross(t.b - t.a, t.c - t.a);
    const double area = glm::length(turn);
    for (const dvec3 corner : {t.a, t.b, t.c}) fresh.extent.add(corner);
    fresh.area += area;
    fresh.centre += area * (t.a + t.b + t.c) / 3.0;
    fresh.normal += turn;
  }
  fresh.power = fresh.area * emitter.emitted;
  fresh.light = fresh.power * emitter.color;
  if (!(fresh.area > 0.0) || !std::isfinite(fresh.power)) return;
  for (size_t i = 0; i < groups_.size();) {
    if (groups_[i].object == fresh.object && touch(groups_[i].extent, fresh.extent)) {
      join(fresh, std::move(groups_[i]));
      groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  groups_.push_back(std::move(fresh));
  if (groups_.size() > kMostGroups) join_nearest();
}

void MgfEmitters::join(Group& group, Group&& other) {
  group.two_sided &= other.two_sided;
  group.extent.add(other.extent);
  group.area += other.area;
  group.centre += other.centre;
  group.normal += other.normal;
  group.power += other.power;
  group.light += other.light;
  // The few to the many: a lamp of many surfaces grows by one after the other.
  if (group.parts.size() < other.parts.size()) group.parts.swap(other.parts);
  group.parts.insert(group.parts.end(), other.parts.begin(), other.parts.end());
}

void MgfEmitters::join_nearest() {
  std::vector<dvec3> centres;
  for (const Group& group : groups_) centres.push_back(group.centre / group.area);
  size_t first = 0, second = 1;
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < groups_.size(); ++i) {
    for (size_t k = i + 1; k < groups_.size(); ++k) {
      const double distance = glm::distance(centres[i], centres[k]);
      if (distance < least) {
        least = distance;
        first = i;
        second = k;
      }
    }
  }
  join(groups_[first], std::move(groups_[second]));
  groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(second));
}

/// Before a flat emitter; beside one that goes round its centre, where the view is long and the way out short.
dvec3 MgfEmitters::position_of(const Group& group, const Scene& scene, const Extent& room) {
  const dvec3 centre = group.centre / group.area;
  const double margin = std::max(0.01 * group.extent.diagonal(), 1e-4 * room.diagonal());
  if (glm::length(group.normal) > 0.1 * group.area) {
    const dvec3 normal = glm::normalize(group.normal);
    const bool away = group.two_sided && glm::dot(normal, room.centre() - centre) < 0.0;
    const dvec3 direction = away ? -normal : normal;
    double outermost = 0.0;
    for (const Emitter& part : group.parts) {
      for (size_t i = 0; i < part.triangles; ++i) {
        const double distance = distance_to(corners_of(scene, part.first_triangle + i), centre, direction);
        if (std::isfinite(distance)) outermost = std::max(outermost, distance);
      }
    }
    return centre + (outermost + margin) * direction;
  }
  dvec3 best = centre;
  double most = -1.0;
  for (int k = 0; k < 6; ++k) {
    const int axis = k / 2;
    const bool down = k % 2 == 0;
    dvec3 direction(0.0);
    direction[axis] = down ? -1.0 : 1.0;
    const double out = margin + (down ? centre[axis] - group.extent.lo[axis] : group.extent.hi[axis] - centre[axis]);
    const dvec3 position = centre + out * direction;
    double view = room.diagonal();
    for (size_t i = 0; i < scene.triangles.size(); ++i) {
      view = std::min(view, distance_to(corners_of(scene, i), position, direction));
    }
    if (view > most * out) {
      most = view / out;
      best = position;
    }
  }
  return best;
}

void MgfEmitters::finish(SceneBuilder& builder, const std::string& place) {
  const size_t found = groups_.size();
  while (groups_.size() > kMostLights) join_nearest();
  const Scene& scene = builder.scene();
  if (found > groups_.size()) {
    builder.warn(place, "there are " + std::to_string(found) + " emitters or more; near ones share one of " +
                            std::to_string(kMostLights) + " lights");
  }
  Extent room;
  for (const Vec3 position : scene.positions) room.add(wide(position));
  // Without attenuation a small lamp would vanish beside a large one: the roots of their powers are nearer each other.
  double sum = 0.0;
  for (const Group& group : groups_) sum += std::sqrt(group.power);
  for (const Group& group : groups_) {
    const dvec3 intensity = group.light / group.power * (kTotalIntensity * std::sqrt(group.power) / sum);
    const dvec3 position = position_of(group, scene, room);
    builder.add_light(
        {Vec3{static_cast<float>(position.x), static_cast<float>(position.y), static_cast<float>(position.z)},
         Vec3{static_cast<float>(intensity.r), static_cast<float>(intensity.g), static_cast<float>(intensity.b)}});
  }
}

}  // namespace raywalk
