// Smooth normals by crease angle.
#include "server/scene/formats/inventor/faces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>

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

  // The faces around each point, next to each other.
  struct Use {
    u32 coordinate, face;
    bool operator<(const Use& other) const {
      return std::tie(coordinate, face) < std::tie(other.coordinate, other.face);
    }
  };
  std::vector<Use> uses;
  uses.reserve(faces.corners.size());
  for (u32 i = 0; i < faces.count(); ++i) {
    for (const IvFaces::Corner& corner : faces.face(i)) uses.push_back({corner.coordinate, i});
  }
  std::sort(uses.begin(), uses.end());

  const double least_cosine = std::cos(std::clamp(crease_angle, 0.0, std::numbers::pi));
  std::vector<dvec3> normals;
  normals.reserve(faces.corners.size());
  for (u32 i = 0; i < faces.count(); ++i) {
    const dvec3 own = face_normals[i];
    for (const IvFaces::Corner& corner : faces.face(i)) {
      dvec3 sum = own;
      auto use = std::lower_bound(uses.begin(), uses.end(), Use{corner.coordinate, 0});
      for (u32 n = 0; n < kMostNeighbours && use != uses.end() && use->coordinate == corner.coordinate; ++n, ++use) {
        const dvec3 other = face_normals[use->face];
        if (use->face != i && glm::dot(own, other) >= least_cosine * glm::length(own) * glm::length(other)) {
          sum += other;
        }
      }
      normals.push_back(sum);
    }
  }
  return normals;
}

}  // namespace raywalk
