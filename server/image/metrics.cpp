// Encoding first; SSIM and FLIP look at neighbourhoods.
#include "server/image/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "server/image/filter.h"
#include "server/image/flip.h"
#include "server/image/srgb.h"
#include "server/image/ssim.h"

namespace raywalk {
namespace {

using Encoded = std::array<float, 3>;

struct Luma {
  std::vector<float> reference, image;
};

float luma_of(const Encoded& c) {
  return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2];
}

bool is_changed(const Encoded& a, const Encoded& b) {
  return !std::equal(a.begin(), a.end(), b.begin(),
                     [](float x, float y) { return std::lround(255.0f * x) == std::lround(255.0f * y); });
}

/// Fills `luma` where SSIM has something to compare, else it stays 0; gives what is summed over single pixels.
ImageMetrics compare_pixels(const Frame& reference, const Frame& image, Luma& luma) {
  const u64 pixels = u64{image.width} * image.height;
  luma.reference.resize(pixels);
  luma.image.resize(pixels);
  std::vector<ImageMetrics> parts(strip_count(image.height));
  // A strip's luma is looked at from the strips beside it, by their differing pixels and those close to them.
  for_strips(image.height, kStripRows + kSsimReach, [&](const Strip& strip, u32 number) {
    if (is_same(strip, reference.pixels, image.pixels, std::size_t{3} * image.width, image.height)) return;
    ImageMetrics part;
    for (u64 i = u64{strip.begin} * image.width; i < u64{strip.end} * image.width; ++i) {
      Encoded a, b;
      for (std::size_t c = 0; c < 3; ++c) {
        const float from = reference.pixels[3 * i + c], to = image.pixels[3 * i + c];
        a[c] = srgb_encoded(from);
        b[c] = bits_of(from) == bits_of(to) ? a[c] : srgb_encoded(to);
        const double difference = double{b[c]} - double{a[c]};
        part.squared_error += difference * difference;
      }
      part.changed_pixels += is_changed(a, b);
      luma.reference[i] = luma_of(a);
      luma.image[i] = luma_of(b);
    }
    parts[number] = part;
  });
  ImageMetrics sum;
  sum.pixels = pixels;
  for (const ImageMetrics& part : parts) {
    sum.squared_error += part.squared_error;
    sum.changed_pixels += part.changed_pixels;
  }
  return sum;
}

void add_flip(std::vector<float> errors, ImageMetrics& metrics) {
  const std::size_t count = errors.size();
  metrics.flip_mean = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(count);
  metrics.flip_max = static_cast<double>(*std::max_element(errors.begin(), errors.end()));
  const auto rank = errors.begin() + static_cast<std::ptrdiff_t>((count * 99 + 99) / 100 - 1);
  std::nth_element(errors.begin(), rank, errors.end());
  metrics.flip_p99 = static_cast<double>(*rank);
}

}  // namespace

double ImageMetrics::rmse() const {
  return pixels == 0 ? 0.0 : std::sqrt(squared_error / (3.0 * static_cast<double>(pixels)));
}

std::optional<double> ImageMetrics::psnr_db() const {
  return squared_error == 0 ? std::nullopt : std::optional(-20.0 * std::log10(rmse()));
}

ImageMetrics compare_pictures(const Frame& reference, const Frame& image) {
  if (reference.width != image.width || reference.height != image.height) {
    throw std::logic_error("images of different sizes were compared");
  }
  const std::size_t values = std::size_t{3} * image.width * image.height;
  if (values == 0 || reference.pixels.size() != values || image.pixels.size() != values) {
    throw std::logic_error("only RGB images with pixels are compared");
  }
  const Strip all{0, image.height, 0};
  if (is_same(all, reference.pixels, image.pixels, std::size_t{3} * image.width, image.height)) {
    ImageMetrics same;
    same.pixels = values / 3;
    return same;
  }
  Luma luma;
  ImageMetrics metrics = compare_pixels(reference, image, luma);
  metrics.ssim = mean_ssim(luma.reference, luma.image, image.width, image.height);
  add_flip(flip_errors(reference, image), metrics);
  return metrics;
}

}  // namespace raywalk
