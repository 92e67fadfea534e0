// The arguments of MGF's `xf`: steps from left to right, some of them repeated, some of them arrays.
#pragma once
#include <glm/mat4x4.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "kernels/platform.h"

namespace raywalk {

class MgfTransform {
 public:
  /// Throws std::runtime_error if the arguments are not understood, or lead to infinity.
  explicit MgfTransform(std::span<const std::string_view> arguments);

  /// The transformation of the array's member at hand; the first one to begin with.
  const glm::dmat4& matrix() const { return matrix_; }
  /// Goes to the next member; false after the last one. The last array runs fastest.
  bool next();
  /// What the next member costs: matrices to multiply.
  size_t parts() const { return parts_.size(); }

 private:
  /// What follows one -i or -a.
  struct Part {
    glm::dmat4 step{1.0};
    u64 repeats = 1;   // of the step; in an array, the member at hand
    u64 members = 0;   // of an array; 0 for -i
    glm::dmat4 all{};  // the step so many times
  };
  void work_out();

  std::vector<Part> parts_{1};
  glm::dmat4 matrix_{1.0};
};

}  // namespace raywalk
