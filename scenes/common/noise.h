// Gradient noise in space and sums of it.
#pragma once
#include "kernels/vec.h"

namespace raywalk {

/// Smooth, about in [-1, 1], zero at lattice points, features of size one.
float noise(Vec3 p);

/// Sum of `octaves` noises, each of twice the frequency and half the height.
float fractal_noise(Vec3 p, int octaves);

}  // namespace raywalk
