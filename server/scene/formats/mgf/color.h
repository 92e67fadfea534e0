// Colours as MGF gives them: chromaticities, spectra and temperatures; and as linear RGB.
#pragma once
#include <glm/vec3.hpp>
#include <span>

namespace raywalk {

/// CIE XYZ with Y = 1: brightness is a matter of the material. The default is MGF's grey.
struct MgfColor {
  glm::dvec3 xyz{1.0, 1.0, 1.0};
};

// Each throws std::runtime_error if there is no such colour.

/// CIE 1931 chromaticity.
MgfColor chromaticity(double x, double y);
/// Values evenly spaced between two wavelengths in nm, and zero outside.
MgfColor spectrum(double from_nm, double to_nm, std::span<const double> values);
/// Black body.
MgfColor temperature(double kelvin);

struct ColorShare {
  double weight;  // of its luminance
  MgfColor color;
};
MgfColor mixture(std::span<const ColorShare> shares);

/// Linear RGB of luminance 1 in the primaries of sRGB, with MGF's grey as white. A colour beyond them is faded until no
/// component is negative.
glm::dvec3 linear_rgb(const MgfColor& color);

}  // namespace raywalk
