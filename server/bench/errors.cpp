// Mismatches, ties and image differences.
#include "server/bench/errors.h"

#include <cmath>
#include <stdexcept>

#include "server/image/srgb.h"

namespace raywalk {
namespace {

constexpr u32 kTieUlps = 2;

/// t is not negative, so its bits are ordered as its values are.
bool is_tie(const Hit& a, const Hit& b) {
  if (a.id == kMiss || b.id == kMiss) return false;
  const u32 low = smaller(bits_of(a.t), bits_of(b.t)), high = larger(bits_of(a.t), bits_of(b.t));
  return high - low <= kTieUlps;
}

double per_million(double count, u64 of) {
  return of == 0 ? 0.0 : 1e6 * count / static_cast<double>(of);
}

}  // namespace

double ErrorFigures::mismatch_ppm() const {
  return per_million(static_cast<double>(id_mismatches), pixels);
}

double ErrorFigures::mismatch_ppm_upper95() const {
  if (id_mismatches == 0) return per_million(3.0, pixels);
  // Wilson and Hilferty's approximation of the Poisson limit.
  const double k = static_cast<double>(id_mismatches) + 1.0;
  const double root = 1.0 - 1.0 / (9.0 * k) + 1.645 / (3.0 * std::sqrt(k));
  return smaller(static_cast<float>(per_million(k * root * root * root, pixels)), 1e6f);
}

double ErrorFigures::image_rmse() const {
  return channels == 0 ? 0.0 : std::sqrt(squared_error / static_cast<double>(channels));
}

void compare_hits(std::span<const Hit> reference, std::span<const Hit> hits, ErrorFigures& figures) {
  if (reference.size() != hits.size()) throw std::logic_error("hits of different frames were compared");
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (reference[i].id == hits[i].id) continue;
    if (is_tie(reference[i], hits[i])) {
      ++figures.ties;
    } else {
      ++figures.id_mismatches;
    }
  }
  figures.pixels += hits.size();
}

void compare_images(std::span<const float> reference, std::span<const float> image, ErrorFigures& figures) {
  if (reference.size() != image.size()) throw std::logic_error("images of different sizes were compared");
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (bits_of(reference[i]) == bits_of(image[i])) continue;
    const double difference = double{srgb_encoded(image[i])} - double{srgb_encoded(reference[i])};
    figures.squared_error += difference * difference;
  }
  figures.channels += image.size();
}

}  // namespace raywalk
