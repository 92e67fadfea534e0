// Colours as the eye blurs them, then edges and points, which are seen however small their colour differs.
#include "server/image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kernels/vec.h"
#include "server/image/filter.h"

namespace raywalk {
namespace {

constexpr double kPixelsPerDegree = 3840.0 * std::numbers::pi / 180.0;
constexpr float kColourExponent = 0.7f;
constexpr float kKnee = 0.4f, kKneeError = 0.95f;  // errors up to this part of the largest fill this part of 0..1
constexpr double kFeatureWidthDeg = 0.082;

// Linear sRGB to XYZ as parts of white (D65 at x = 0.31271, y = 0.32902) and back.
constexpr float kToXyz[3][3] = {{0.43389539f, 0.37624237f, 0.18986224f},
                                {0.21263682f, 0.71518298f, 0.07218020f},
                                {0.01775242f, 0.10946563f, 0.87278195f}};
constexpr float kToRgb[3][3] = {{3.08034199f, -1.53739897f, -0.54294302f},
                                {-0.92117840f, 1.87592998f, 0.04524841f},
                                {0.05288129f, -0.20401121f, 1.15112991f}};

[[gnu::always_inline]] inline Vec3 transformed(const float (&m)[3][3], Vec3 v) {
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

[[gnu::always_inline]] inline Vec3 clipped(Vec3 v) {
  const auto unit = [](float x) { return smaller(larger(x, 0.0f), 1.0f); };
  return {unit(v.x), unit(v.y), unit(v.z)};
}

/// Sensitivity to contrast falls with frequency as a sum of Gaussians a exp(-b f^2): here its inverse transform.
struct Sensitivity {
  double a, b;

  double sigma_px() const { return std::sqrt(b / 2.0) / std::numbers::pi * kPixelsPerDegree; }
  double amplitude() const { return a * std::sqrt(std::numbers::pi / b); }
};
constexpr Sensitivity kLuminance{1.0, 0.0047}, kRedGreen{1.0, 0.0053}, kBlueWide{34.1, 0.04}, kBlueNarrow{13.5, 0.025};

/// Three standard deviations of the widest. Narrow Gaussians end where a float no longer sees them.
const u32 kColourRadius = static_cast<u32>(std::ceil(3.0 * kBlueWide.sigma_px()));

Taps taps_of(const Sensitivity& s) {
  return gaussian_taps(s.sigma_px(),
                       std::min(static_cast<int>(kColourRadius), static_cast<int>(6.0 * s.sigma_px()) + 1));
}

struct ColourFilters {
  Taps luminance = taps_of(kLuminance), red_green = taps_of(kRedGreen);
  Taps blue_wide = taps_of(kBlueWide), blue_narrow = taps_of(kBlueNarrow);
  float wide_share = 0;  // of the two blue ones, as filters of sum 1

  ColourFilters() {
    const auto weight = [](const Sensitivity& s) {
      double sum = 0;
      for (int x = -static_cast<int>(kColourRadius); x <= static_cast<int>(kColourRadius); ++x) {
        sum += std::exp(-x * x / (2.0 * s.sigma_px() * s.sigma_px()));
      }
      return s.amplitude() * sum * sum;
    };
    const double wide = weight(kBlueWide), narrow = weight(kBlueNarrow);
    wide_share = static_cast<float>(wide / (wide + narrow));
  }
};

/// A Gaussian and its first two derivatives, the latter with positive and negative weights of sum 1 and -1.
struct FeatureFilters {
  Taps smooth, edge, point;

  FeatureFilters() {
    const double sigma = 0.5 * kFeatureWidthDeg * kPixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    smooth = gaussian_taps(sigma, radius);
    for (int x = -radius; x <= radius; ++x) {
      const float gaussian = smooth[static_cast<std::size_t>(x + radius)];
      edge.push_back(static_cast<float>(-x) * gaussian);
      point.push_back(static_cast<float>(x * x / (sigma * sigma) - 1.0) * gaussian);
    }
    balance(edge);
    balance(point);
  }

  static void balance(Taps& taps) {
    float positive = 0, negative = 0;
    for (const float tap : taps) (tap > 0 ? positive : negative) += tap;
    for (float& tap : taps) tap /= tap > 0 ? positive : -negative;
  }
};

/// A strip of a picture: luminance (0..1), red against green, yellow against blue.
struct Opponent {
  Plane luminance, red_green, yellow_blue;
};

Opponent load(const Frame& frame, const Strip& strip) {
  const Plane empty(frame.width, strip.loaded_rows(), strip.halo);
  Opponent out{empty, empty, empty};
  for (u32 i = 0; i < strip.loaded_rows(); ++i) {
    const float* rgb = frame.pixels.data() + std::size_t{3} * frame.width * strip.source_row(i, frame.height);
    float* luminance = out.luminance.row(i) + strip.halo;
    float* red_green = out.red_green.row(i) + strip.halo;
    float* yellow_blue = out.yellow_blue.row(i) + strip.halo;
    for (u32 x = 0; x < frame.width; ++x, rgb += 3) {
      const Vec3 xyz = transformed(kToXyz, clipped({rgb[0], rgb[1], rgb[2]}));
      luminance[x] = xyz.y;
      red_green[x] = xyz.x - xyz.y;
      yellow_blue[x] = xyz.y - xyz.z;
    }
  }
  for (Plane* plane : {&out.luminance, &out.red_green, &out.yellow_blue}) plane->clamp_columns();
  return out;
}

/// Of t in 0.008..2 within 4 ulp; inlined and without calls, so that a row is computed in vectors.
[[gnu::always_inline]] inline float cube_root(float t) {
  float y = float_of(bits_of(t) / 3 + 0x2a510000u);  // a third of the exponent
  for (int halley = 0; halley < 2; ++halley) {
    const float cube = y * y * y;
    y *= (cube + 2.0f * t) / (2.0f * cube + t);
  }
  return y;
}

/// CIELAB with colourfulness that grows with lightness (Hunt's effect).
[[gnu::always_inline]] inline Vec3 perceived(Vec3 rgb) {
  const auto curve = [](float t) {
    constexpr float kDelta = 6.0f / 29.0f;
    constexpr float kLinear = kDelta * kDelta * kDelta;
    return t > kLinear ? cube_root(larger(t, kLinear)) : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
  };
  const Vec3 xyz = transformed(kToXyz, rgb);
  const float x = curve(xyz.x), y = curve(xyz.y), z = curve(xyz.z);
  const float lightness = 116.0f * y - 16.0f;
  return {lightness, 0.01f * lightness * 500.0f * (x - y), 0.01f * lightness * 200.0f * (y - z)};
}

/// The HyAB distance.
[[gnu::always_inline]] inline float colour_distance(Vec3 a, Vec3 b) {
  const float da = a.y - b.y, db = a.z - b.z;
  return magnitude(a.x - b.x) + std::sqrt(da * da + db * db);
}

/// Raises distances, so that large ones count less, and maps them to 0..1 with a knee: the largest that sRGB knows,
/// green against blue, to 1.
float colour_error(float distance) {
  static const float largest = std::pow(colour_distance(perceived({0, 1, 0}), perceived({0, 0, 1})), kColourExponent);
  const float knee = kKnee * largest, raised = std::pow(distance, kColourExponent);
  if (raised < knee) return raised * (kKneeError / knee);
  return kKneeError + (raised - knee) / (largest - knee) * (1.0f - kKneeError);
}

Opponent blurred(const Opponent& strip, u32 halo) {
  static const ColourFilters filters;
  const auto blur = [&](const Plane& plane, const Taps& taps) {
    return filtered_down(filtered_across(plane, taps), taps, halo);
  };
  Plane wide = blur(strip.yellow_blue, filters.blue_wide);
  const Plane narrow = blur(strip.yellow_blue, filters.blue_narrow);
  for (u32 y = 0; y < wide.rows(); ++y) {
    for (u32 x = 0; x < wide.width(); ++x) {
      wide.row(y)[x] = filters.wide_share * wide.row(y)[x] + (1.0f - filters.wide_share) * narrow.row(y)[x];
    }
  }
  return {blur(strip.luminance, filters.luminance), blur(strip.red_green, filters.red_green), std::move(wide)};
}

/// Colour distances of a row of two blurred strips.
void row_distances(const Opponent& a, const Opponent& b, u32 y, float* distances) {
  const auto perceived_at = [y](const Opponent& strip, u32 x) {
    const float luminance = strip.luminance.row(y)[x];
    const Vec3 xyz{luminance + strip.red_green.row(y)[x], luminance, luminance - strip.yellow_blue.row(y)[x]};
    return perceived(clipped(transformed(kToRgb, xyz)));
  };
  for (u32 x = 0; x < a.luminance.width(); ++x) distances[x] = colour_distance(perceived_at(a, x), perceived_at(b, x));
}

/// How strong edges and points are.
struct Features {
  Plane edge, point;
};

Features features_of(const Plane& luminance, u32 halo) {
  static const FeatureFilters filters;
  const Plane smooth = filtered_across(luminance, filters.smooth);
  const auto strength = [&](const Taps& derivative) {
    Plane across = filtered_down(filtered_across(luminance, derivative), filters.smooth, halo);
    const Plane down = filtered_down(smooth, derivative, halo);
    for (u32 y = 0; y < across.rows(); ++y) {
      float* a = across.row(y);
      const float* d = down.row(y);
      for (u32 x = 0; x < across.width(); ++x) a[x] = std::sqrt(a[x] * a[x] + d[x] * d[x]);
    }
    return across;
  };
  return {strength(filters.edge), strength(filters.point)};
}

void strip_errors(const Frame& reference, const Frame& image, const Strip& strip, float* errors) {
  const Opponent a = load(reference, strip), b = load(image, strip);
  const Opponent blurred_a = blurred(a, strip.halo), blurred_b = blurred(b, strip.halo);
  const Features features_a = features_of(a.luminance, strip.halo), features_b = features_of(b.luminance, strip.halo);
  for (u32 y = 0; y < strip.rows(); ++y, errors += reference.width) {
    row_distances(blurred_a, blurred_b, y, errors);
    for (u32 x = 0; x < reference.width; ++x) {
      const float edge = magnitude(features_a.edge.row(y)[x] - features_b.edge.row(y)[x]);
      const float point = magnitude(features_a.point.row(y)[x] - features_b.point.row(y)[x]);
      const float feature = smaller(larger(edge, point) / std::numbers::sqrt2_v<float>, 1.0f);
      errors[x] = std::pow(colour_error(errors[x]), 1.0f - std::sqrt(feature));
    }
  }
}

}  // namespace

std::vector<float> flip_errors(const Frame& reference, const Frame& image) {
  std::vector<float> errors(std::size_t{reference.width} * reference.height);
  for_strips(reference.height, kColourRadius, [&](const Strip& strip, u32) {
    // The eye blurs no farther than the strip's neighbours.
    if (is_same(strip, reference.pixels, image.pixels, std::size_t{3} * reference.width, reference.height)) return;
    strip_errors(reference, image, strip, errors.data() + std::size_t{strip.begin} * reference.width);
  });
  return errors;
}

}  // namespace raywalk
