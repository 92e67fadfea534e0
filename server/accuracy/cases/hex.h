// Rays, hits and triangles as text with hexadecimal floats, which keep every bit.
#pragma once
#include <string>

#include "kernels/ray.h"

namespace raywalk::accuracy {

struct Failure;

/// Such as -0x1.8p+1, inf, nan.
std::string text_of(float a);
std::string text_of(const Ray& ray);
std::string text_of(const Hit& hit);
/// What is wrong, the ray, and each triangle with its id.
std::string text_of(const Failure& failure);

}  // namespace raywalk::accuracy
