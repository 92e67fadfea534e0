// Smooth normals by crease angle.
#include "server/scene/formats/inventor/faces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace raywalk {
namespace {

using glm::dvec3;

constexpr u32 kMostNeighbours = 64;  // faces that are looked at around one point

/// Newell's normal: twice the area in length, for polygons that are not flat too.
dvec3 area_normal(std::span<const IvFaces::Corner> face, std::span<const double> coordinates) {
  dvec3 sum(0.0);
  for (size_t i = 0; i < face.size(); ++i) {
    sum += glm::cross(triple(coordinates, face[i].coordinate),
                      triple(coordinates, face[(i + 1) % face.size()].coordinate));
  }
  return sum;
}

}  // namespace

std::vector<dvec3> smooth_normals(const IvFaces& faces, std::span<const double> coordinates, double crease_angle) {
  std::vector<dvec3> face_normals(faces.count());
  for (u32 i = 0; i < faces.count(); ++i) face_normals[i] = area_normal(faces.face(i), coordinates);

  // The faces around each point: first[p] up to first[p + 1].
  std::vector<u32> first(coordinates.size() / 3 + 1, 0);
  for (const IvFaces::Corner& corner : faces.corners) ++first[corner.coordinate + 1];
  for (size_t p = 1; p < first.size(); ++p) first[p] += first[p - 1];
  std::vector<u32> around(faces.corners.size());
  std::vector<u32> filled(first.begin(), first.end());
  for (u32 i = 0; i < faces.count(); ++i) {
    for (const IvFaces::Corner& corner : faces.face(i)) around[filled[corner.coordinate]++] = i;
  }

  const double least_cosine = std::cos(std::clamp(crease_angle, 0.0, std::numbers::pi));
  std::vector<dvec3> normals;
  normals.reserve(faces.corners.size());
  for (u32 i = 0; i < faces.count(); ++i) {
    const dvec3 own = face_normals[i];
    for (const IvFaces::Corner& corner : faces.face(i)) {
      dvec3 sum = own;
      const u32 end = std::min(first[corner.coordinate + 1], first[corner.coordinate] + kMostNeighbours);
      for (u32 at = first[corner.coordinate]; at < end; ++at) {
        const dvec3 other = face_normals[around[at]];
        if (around[at] != i && glm::dot(own, other) >= least_cosine * glm::length(own) * glm::length(other)) {
          sum += other;
        }
      }
      normals.push_back(sum);
    }
  }
  return normals;
}

}  // namespace raywalk
