// Mismatches, ties and image differences.
#include "server/bench/errors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "server/accuracy/rate.h"
#include "server/image/metrics.h"

namespace raywalk {
namespace {

constexpr u32 kTieUlps = 2;

/// t is not negative, so its bits are ordered as its values are.
bool is_tie(const Hit& a, const Hit& b) {
  if (a.id == kMiss || b.id == kMiss) return false;
  const u32 low = smaller(bits_of(a.t), bits_of(b.t)), high = larger(bits_of(a.t), bits_of(b.t));
  return high - low <= kTieUlps;
}

}  // namespace

double ErrorFigures::wrong_ppm() const {
  return per_million(static_cast<double>(wrong_rays()), checked_rays());
}

double ErrorFigures::wrong_ppm_upper95() const {
  return upper95_ppm(wrong_rays(), checked_rays());
}

double ErrorFigures::mismatch_ppm() const {
  return per_million(static_cast<double>(id_mismatches), pixels);
}

double ErrorFigures::mismatch_ppm_upper95() const {
  return upper95_ppm(id_mismatches, pixels);
}

double ErrorFigures::image_rmse() const {
  return images == 0 ? 0.0 : std::sqrt(squared_error / (3.0 * static_cast<double>(image_pixels)));
}

std::optional<double> ErrorFigures::image_ssim() const {
  return of_images(ssim_sum / static_cast<double>(images));
}

std::optional<double> ErrorFigures::image_flip_mean() const {
  return of_images(flip_sum / static_cast<double>(images));
}

std::optional<double> ErrorFigures::image_flip_p99() const {
  return of_images(flip_p99);
}

std::optional<double> ErrorFigures::image_flip_max() const {
  return of_images(flip_max);
}

std::optional<double> ErrorFigures::changed_pixels_ppm() const {
  return of_images(per_million(static_cast<double>(changed_pixels), image_pixels));
}

void ErrorFigures::add_rays(const ErrorFigures& other) {
  pixels += other.pixels;
  id_mismatches += other.id_mismatches;
  ties += other.ties;
  primary += other.primary;
  shadow += other.shadow;
}

std::optional<double> ErrorFigures::of_images(double figure) const {
  return images == 0 ? std::nullopt : std::optional(figure);
}

std::vector<u32> compare_hits(std::span<const Hit> reference, std::span<const Hit> hits, ErrorFigures& figures) {
  if (reference.size() != hits.size()) throw std::logic_error("hits of different frames were compared");
  std::vector<u32> differing;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (reference[i].id == hits[i].id) continue;
    if (is_tie(reference[i], hits[i])) {
      ++figures.ties;
    } else {
      differing.push_back(static_cast<u32>(i));
    }
  }
  figures.pixels += hits.size();
  figures.id_mismatches += differing.size();
  return differing;
}

void compare_images(const Frame& reference, const Frame& image, ErrorFigures& figures) {
  const ImageMetrics metrics = compare_pictures(reference, image);
  ++figures.images;
  figures.image_pixels += metrics.pixels;
  figures.changed_pixels += metrics.changed_pixels;
  figures.squared_error += metrics.squared_error;
  figures.ssim_sum += metrics.ssim;
  figures.flip_sum += metrics.flip_mean;
  figures.flip_p99 = std::max(figures.flip_p99, metrics.flip_p99);
  figures.flip_max = std::max(figures.flip_max, metrics.flip_max);
}

}  // namespace raywalk
