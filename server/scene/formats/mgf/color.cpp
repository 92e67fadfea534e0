// Colorimetry. The matching functions are the fits of Wyman, Sloan and Shirley, "Simple Analytic Approximations to the
// CIE XYZ Color Matching Functions", JCGT 2(2), 2013.
#include "server/scene/formats/mgf/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>

#include "kernels/platform.h"

namespace raywalk {
namespace {

using glm::dmat3;
using glm::dvec3;

constexpr double kFromNm = 380.0, kStepNm = 5.0;
constexpr u32 kSteps = 81;  // to 780 nm

/// A bell with its own width on either side of its peak.
double lobe(double nm, double peak, double below, double above) {
  const double distance = (nm - peak) / (nm < peak ? below : above);
  return std::exp(-0.5 * distance * distance);
}

dvec3 matching(double nm) {
  return {
      1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) - 0.065 * lobe(nm, 501.1, 20.4, 26.2),
      0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
      1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

template <class Power>
dvec3 integral(Power power) {
  static const auto matches = [] {
    std::array<dvec3, kSteps> all;
    for (u32 i = 0; i < kSteps; ++i) all[i] = matching(kFromNm + i * kStepNm);
    return all;
  }();
  dvec3 sum(0.0);
  for (u32 i = 0; i < kSteps; ++i) sum += power(kFromNm + i * kStepNm) * matches[i];
  return sum;
}

/// Colours that are nearly without luminance lead to infinity.
MgfColor checked(const dvec3& xyz) {
  constexpr double kMost = 1e6;
  for (const double part : {xyz.x, xyz.y, xyz.z}) {
    if (!(std::abs(part) <= kMost)) throw std::runtime_error("no colour has so little luminance");
  }
  return {xyz};
}

template <class Power>
MgfColor color_of(Power power) {
  static const dvec3 flat = integral([](double) { return 1.0; });
  const dvec3 xyz = integral(power) / flat;  // an even spectrum is grey, exactly
  if (!(xyz.y > 0.0) || !std::isfinite(xyz.x + xyz.y + xyz.z)) throw std::runtime_error("a spectrum without light");
  return checked(xyz / xyz.y);
}

dmat3 rgb_from_xyz() {
  const auto xyz = [](double x, double y) { return dvec3(x, y, 1.0 - x - y); };
  const dmat3 primaries(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
  const dvec3 share = glm::inverse(primaries) * dvec3(1.0);
  return glm::inverse(dmat3(share.r * primaries[0], share.g * primaries[1], share.b * primaries[2]));
}

}  // namespace

MgfColor chromaticity(double x, double y) {
  constexpr double kRounding = 1e-3;
  if (x < 0.0 || y <= 0.0 || x + y > 1.0 + kRounding) throw std::runtime_error("no colour has this chromaticity");
  return checked({x / y, 1.0, std::max(1.0 - x - y, 0.0) / y});
}

MgfColor spectrum(double from_nm, double to_nm, std::span<const double> values) {
  if (!(from_nm < to_nm))
    throw std::runtime_error("the wavelengths of a spectrum go from the shorter to the longer one");
  return color_of([&](double nm) {
    if (nm < from_nm || nm > to_nm) return 0.0;
    const double at = (nm - from_nm) / (to_nm - from_nm) * static_cast<double>(values.size() - 1);
    const size_t left = static_cast<size_t>(at), right = std::min(left + 1, values.size() - 1);
    const double part = at - static_cast<double>(left);
    return (1.0 - part) * values[left] + part * values[right];
  });
}

MgfColor temperature(double kelvin) {
  if (!(kelvin > 0.0)) throw std::runtime_error("a temperature is above zero");
  const double clamped = std::clamp(kelvin, 500.0, 1e6);
  return color_of([&](double nm) {
    constexpr double kSecondRadiation = 1.438777e7;  // nm K
    return std::pow(nm / 560.0, -5.0) / std::expm1(kSecondRadiation / (nm * clamped));
  });
}

MgfColor mixture(std::span<const ColorShare> shares) {
  dvec3 sum(0.0);
  double weights = 0.0;
  for (const ColorShare& share : shares) {
    if (share.weight < 0.0) throw std::runtime_error("a negative weight in a mixture");
    sum += share.weight * share.color.xyz;
    weights += share.weight;
  }
  if (!(weights > 0.0) || !std::isfinite(weights)) throw std::runtime_error("the weights of a mixture have no sum");
  return checked(sum / weights);
}

dvec3 linear_rgb(const MgfColor& color) {
  static const dmat3 matrix = rgb_from_xyz();
  const dvec3 rgb = matrix * color.xyz;
  const double least = std::min({rgb.r, rgb.g, rgb.b});
  return least < 0.0 ? (rgb - least) / (1.0 - least) : rgb;  // grey, (1, 1, 1), is as bright
}

}  // namespace raywalk
