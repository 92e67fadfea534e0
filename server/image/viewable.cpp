// Colours for what is not a colour.
#include "server/image/viewable.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "server/image/srgb.h"

namespace raywalk {
namespace {

struct Rgb {
  u8 r, g, b;
};

u8 byte_of(float unit) {
  return static_cast<u8>(smaller(larger(unit, 0.0f), 1.0f) * 255.0f + 0.5f);
}

/// A dark blue to red ramp of even steps in brightness up to yellow; `t` in [0, 1].
Rgb heat(float t) {
  constexpr std::array<std::array<float, 3>, 6> kStops = {{{0.05f, 0.03f, 0.20f},
                                                           {0.16f, 0.22f, 0.58f},
                                                           {0.10f, 0.55f, 0.60f},
                                                           {0.35f, 0.78f, 0.32f},
                                                           {0.96f, 0.86f, 0.22f},
                                                           {0.86f, 0.16f, 0.12f}}};
  const float x = smaller(larger(t, 0.0f), 1.0f) * static_cast<float>(kStops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), kStops.size() - 2);
  const float f = x - static_cast<float>(i);
  const auto mix = [&](std::size_t c) { return byte_of(kStops[i][c] + f * (kStops[i + 1][c] - kStops[i][c])); };
  return {mix(0), mix(1), mix(2)};
}

/// Neighbouring ids get unlike colours, none of them dark.
Rgb colour_of_id(u32 id) {
  u32 h = id * 2654435761u;
  h = (h ^ (h >> 15)) * 2246822519u;
  h ^= h >> 13;
  return {static_cast<u8>(64 + (h & 0xff) * 3 / 4), static_cast<u8>(64 + ((h >> 8) & 0xff) * 3 / 4),
          static_cast<u8>(64 + ((h >> 16) & 0xff) * 3 / 4)};
}

template <class Colour>
std::vector<u8> per_pixel(const Frame& frame, Colour&& colour) {
  const std::size_t pixels = std::size_t{frame.width} * frame.height;
  std::vector<u8> bytes(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const Rgb c = colour(frame.pixels.data() + i * frame.channels);
    bytes[3 * i] = c.r;
    bytes[3 * i + 1] = c.g;
    bytes[3 * i + 2] = c.b;
  }
  return bytes;
}

std::vector<u8> depth_as_grey(const Frame& frame) {
  float near = kMaxFloat, far = 0.0f;
  for (const float t : frame.pixels) {
    if (is_finite(t) && t < kMaxFloat) {
      near = smaller(t, near);
      far = larger(t, far);
    }
  }
  const float span = far > near ? far - near : 1.0f;
  return per_pixel(frame, [&](const float* p) -> Rgb {
    if (!is_finite(*p) || *p >= kMaxFloat) return {0, 0, 0};
    const u8 grey = byte_of(1.0f - 0.85f * ((*p - near) / span));
    return {grey, grey, grey};
  });
}

std::vector<u8> steps_as_heat(const Frame& frame) {
  std::vector<float> work;
  work.reserve(frame.pixels.size() / 2);
  for (std::size_t i = 0; i + 1 < frame.pixels.size(); i += 2) work.push_back(frame.pixels[i] + frame.pixels[i + 1]);
  float scale = 1.0f;
  if (!work.empty()) {
    const auto rank = work.begin() + static_cast<std::ptrdiff_t>((work.size() - 1) * 99 / 100);
    std::nth_element(work.begin(), rank, work.end());
    scale = larger(*rank, 1.0f);
  }
  return per_pixel(frame, [&](const float* p) { return heat((p[0] + p[1]) / scale); });
}

}  // namespace

std::vector<u8> viewable(const Frame& frame, Output output) {
  switch (output) {
    case Output::color: {
      std::vector<u8> bytes(frame.pixels.size());
      srgb_bytes(frame.pixels, bytes.data());
      return bytes;
    }
    case Output::normal:
      return per_pixel(frame, [](const float* p) -> Rgb {
        return {byte_of(0.5f + 0.5f * p[0]), byte_of(0.5f + 0.5f * p[1]), byte_of(0.5f + 0.5f * p[2])};
      });
    case Output::id:
      return per_pixel(frame, [](const float* p) -> Rgb {
        return *p < 0.0f ? Rgb{0, 0, 0} : colour_of_id(static_cast<u32>(*p));
      });
    case Output::depth:
      return depth_as_grey(frame);
    case Output::steps:
      return steps_as_heat(frame);
  }
  return {};
}

}  // namespace raywalk
