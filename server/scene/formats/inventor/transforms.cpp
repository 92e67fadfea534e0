// Nodes that move what follows.
#include <glm/gtc/matrix_transform.hpp>

#include "server/scene/formats/inventor/interpreter.h"

namespace raywalk {
namespace {

using glm::dmat4;
using glm::dvec3;

dmat4 turn(glm::dvec4 axis_angle) {
  const dvec3 axis(axis_angle);
  const double length = glm::length(axis);
  return length > 0.0 ? glm::rotate(dmat4(1.0), axis_angle.w, axis / length) : dmat4(1.0);
}

}  // namespace

void IvInterpreter::matrix_transform(const IvFields& f) {
  const std::span<const double> m = f.list("matrix", 16);
  if (m.empty()) return;
  if (m.size() != 16) f.fail("matrix", "more than 16 numbers");
  // Rows of the file, which is for row vectors, are columns here.
  dmat4 local;
  for (int row = 0; row < 4; ++row) local[row] = {m[row * 4], m[row * 4 + 1], m[row * 4 + 2], m[row * 4 + 3]};
  if (local[0].w != 0.0 || local[1].w != 0.0 || local[2].w != 0.0 || local[3].w == 0.0) {
    f.fail("matrix", "projective matrices are not supported");
  }
  move(local / local[3].w);
}

void IvInterpreter::translation(const IvFields& f) {
  move(glm::translate(dmat4(1.0), f.vector("translation", dvec3(0.0))));
}

void IvInterpreter::rotation(const IvFields& f) {
  move(turn(f.rotation("rotation")));
}

void IvInterpreter::rotation_xyz(const IvFields& f) {
  const std::string_view axis = f.word("axis");
  move(turn({axis.empty() || axis == "X", axis == "Y", axis == "Z", f.number("angle", 0.0)}));
}

void IvInterpreter::scale(const IvFields& f) {
  move(glm::scale(dmat4(1.0), f.vector("scaleFactor", dvec3(1.0))));
}

void IvInterpreter::transform(const IvFields& f) {
  const dvec3 centre = f.vector("center", dvec3(0.0));
  const dmat4 orientation = turn(f.rotation("scaleOrientation"));
  const dmat4 scaling = glm::scale(dmat4(1.0), f.vector("scaleFactor", dvec3(1.0)));
  const dmat4 to_centre = glm::translate(dmat4(1.0), f.vector("translation", dvec3(0.0)) + centre);
  move(to_centre * turn(f.rotation("rotation")) * orientation * scaling * glm::transpose(orientation) *
       glm::translate(dmat4(1.0), -centre));
}

void IvInterpreter::texture_transform(const IvFields& f) {
  const auto pair = [&](std::string_view name, double otherwise) {
    const std::span<const double> n = f.list(name, 2);
    return n.empty() ? dvec3(otherwise, otherwise, 0.0) : dvec3(n[0], n[1], 0.0);
  };
  const dvec3 centre = pair("center", 0.0), scaling = pair("scaleFactor", 1.0);
  dmat4 m = glm::translate(dmat4(1.0), pair("translation", 0.0) + centre);
  m = glm::rotate(m, f.number("rotation", 0.0), dvec3(0, 0, 1));
  m = glm::translate(glm::scale(m, {scaling.x, scaling.y, 1.0}), -centre);
  state_.texture_transform = state_.texture_transform *
                             glm::dmat3(dvec3(m[0].x, m[0].y, 0), dvec3(m[1].x, m[1].y, 0), dvec3(m[3].x, m[3].y, 1));
}

}  // namespace raywalk
