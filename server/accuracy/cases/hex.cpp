// Hexadecimal floats.
#include "server/accuracy/cases/hex.h"

#include <cstdio>

#include "server/accuracy/cases/exam.h"

namespace raywalk::accuracy {
namespace {

constexpr std::size_t kMostTriangles = 16;

std::string vector_text(Vec3 a) {
  char text[96];
  std::snprintf(text, sizeof text, "(%a, %a, %a)", double{a.x}, double{a.y}, double{a.z});
  return text;
}

}  // namespace

std::string text_of(float a) {
  char text[32];
  std::snprintf(text, sizeof text, "%a", double{a});
  return text;
}

std::string text_of(const Ray& ray) {
  return "o " + vector_text(ray.o) + " d " + vector_text(ray.d) + " t [" + text_of(ray.tmin) + ", " +
         text_of(ray.tmax) + "]";
}

std::string text_of(const Hit& hit) {
  if (hit.id == kMiss) return "miss";
  return "id " + std::to_string(hit.id) + " t " + text_of(hit.t) + " u " + text_of(hit.u) + " v " + text_of(hit.v);
}

std::string text_of(const Failure& failure) {
  std::string text = failure.what + ": ray " + text_of(failure.ray);
  for (std::size_t i = 0; i < failure.triangles.size() && i < kMostTriangles; ++i) {
    const Corners& t = failure.triangles[i];
    text +=
        "; triangle " + std::to_string(t.id) + " " + vector_text(t.a) + " " + vector_text(t.b) + " " + vector_text(t.c);
  }
  if (failure.triangles.size() > kMostTriangles)
    text += "; and " + std::to_string(failure.triangles.size() - kMostTriangles) + " more triangles";
  return text;
}

}  // namespace raywalk::accuracy
