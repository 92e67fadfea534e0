// Order statistics, spread and a bootstrap interval.
#include "server/bench/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

namespace raywalk {
namespace {

constexpr u32 kSeed = 20090507;
constexpr std::size_t kMostResamples = 2000, kFewestResamples = 200, kBootstrapDraws = 800'000;

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double squared_deviations(std::span<const double> values, double mean) {
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [mean](double sum, double v) { return sum + (v - mean) * (v - mean); });
}

/// Reorders `values`.
double median_of(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

void bootstrap_median(std::span<const double> samples, Statistics& out) {
  std::mt19937_64 random(kSeed);
  const std::size_t resamples = std::clamp(kBootstrapDraws / samples.size(), kFewestResamples, kMostResamples);
  std::vector<double> draw(samples.size()), medians(resamples);
  for (double& median : medians) {
    for (double& value : draw) value = samples[random() % samples.size()];
    median = median_of(draw);
  }
  std::sort(medians.begin(), medians.end());
  out.ci95_low = percentile(medians, 0.025);
  out.ci95_high = percentile(medians, 0.975);
}

}  // namespace

double percentile(std::span<const double> sorted, double p) {
  const double rank = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  if (below + 1 >= sorted.size()) return sorted.back();
  return sorted[below] + (rank - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

double pooled_spread(std::span<const std::vector<double>> repeats_of_frames) {
  double sum = 0;
  std::size_t freedom = 0;
  for (const std::vector<double>& repeats : repeats_of_frames) {
    if (repeats.size() < 2) continue;
    const double mean = mean_of(repeats);
    if (mean > 0) sum += squared_deviations(repeats, mean) / (mean * mean);
    freedom += repeats.size() - 1;
  }
  return freedom == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(freedom));
}

Statistics summarise(std::span<const std::vector<double>> repeats_of_frames) {
  std::vector<double> sorted;
  for (const std::vector<double>& repeats : repeats_of_frames) {
    sorted.insert(sorted.end(), repeats.begin(), repeats.end());
  }
  if (sorted.empty()) throw std::invalid_argument("there are no samples");
  std::sort(sorted.begin(), sorted.end());

  Statistics s;
  s.samples = sorted.size();
  s.mean = mean_of(sorted);
  s.sd =
      sorted.size() < 2 ? 0.0 : std::sqrt(squared_deviations(sorted, s.mean) / static_cast<double>(sorted.size() - 1));
  s.median = percentile(sorted, 0.5);
  s.min = sorted.front();
  s.p5 = percentile(sorted, 0.05);
  s.p95 = percentile(sorted, 0.95);
  s.p99 = percentile(sorted, 0.99);
  std::vector<double> deviations;
  for (const double v : sorted) deviations.push_back(std::abs(v - s.median));
  s.mad = median_of(deviations);
  bootstrap_median(sorted, s);
  s.unstable = pooled_spread(repeats_of_frames) > kUnstableSpread;
  return s;
}

}  // namespace raywalk
