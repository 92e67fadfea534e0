// Counting verdicts and errors of t.
#include "server/accuracy/oracle/figures.h"

#include <algorithm>
#include <cmath>

namespace raywalk::oracle {

const char* name_of(Verdict v) {
  constexpr const char* kNames[kVerdicts] = {"right", "tie",        "boundary", "near",
                                             "leak",  "false_miss", "wrong_id", "false_hit"};
  return kNames[static_cast<u32>(v)];
}

const char* name_of(RayClass c) {
  constexpr const char* kNames[kRayClasses] = {"strict", "tie", "near", "boundary"};
  return kNames[static_cast<u32>(c)];
}

u32 UlpHistogram::bin_of(double ulps) {
  constexpr auto kBins = static_cast<i32>((kHighestOctave - kLowestOctave) * kBinsPerOctave);
  if (ulps < std::ldexp(1.0, kLowestOctave)) return 0;
  if (ulps >= std::ldexp(1.0, kHighestOctave)) return kBins + 1;
  int exponent;
  const double mantissa = std::frexp(ulps, &exponent);  // in [0.5, 1)
  const auto part = static_cast<i32>((mantissa - 0.5) * 2.0 * kBinsPerOctave);
  return static_cast<u32>((exponent - 1 - kLowestOctave) * kBinsPerOctave + part + 1);
}

void UlpHistogram::add(double ulps) {
  ++bins_[bin_of(ulps)];
  ++count_;
  largest_ = std::max(largest_, ulps);
}

void UlpHistogram::add(const UlpHistogram& other) {
  for (u32 i = 0; i < bins_.size(); ++i) bins_[i] += other.bins_[i];
  count_ += other.count_;
  largest_ = std::max(largest_, other.largest_);
}

double UlpHistogram::percentile(double fraction) const {
  const auto wanted = static_cast<u64>(std::ceil(fraction * static_cast<double>(count_)));
  u64 seen = 0;
  for (u32 i = 0; i + 1 < bins_.size(); ++i) {
    seen += bins_[i];
    if (seen >= wanted) {
      const double upper = std::ldexp(1.0 + (i % kBinsPerOctave) / static_cast<double>(kBinsPerOctave),
                                      kLowestOctave + static_cast<i32>(i / kBinsPerOctave));
      return std::min(upper, largest_);
    }
  }
  return largest_;
}

void Figures::add(const Judgement& judgement) {
  ++counts[static_cast<u32>(judgement.ray_class)][static_cast<u32>(judgement.verdict)];
  if (!judgement.t_ulps) return;
  t_ulps.add(*judgement.t_ulps);
  if (judgement.well_conditioned) well_conditioned_t_ulps.add(*judgement.t_ulps);
}

void Figures::add(const Figures& other) {
  for (u32 c = 0; c < kRayClasses; ++c) {
    for (u32 v = 0; v < kVerdicts; ++v) counts[c][v] += other.counts[c][v];
  }
  t_ulps.add(other.t_ulps);
  well_conditioned_t_ulps.add(other.well_conditioned_t_ulps);
}

u64 Figures::rays() const {
  u64 sum = 0;
  for (u32 v = 0; v < kVerdicts; ++v) sum += count(static_cast<Verdict>(v));
  return sum;
}

u64 Figures::count(Verdict verdict) const {
  u64 sum = 0;
  for (const auto& row : counts) sum += row[static_cast<u32>(verdict)];
  return sum;
}

u64 Figures::count(RayClass ray_class) const {
  u64 sum = 0;
  for (const u64 n : counts[static_cast<u32>(ray_class)]) sum += n;
  return sum;
}

u64 Figures::wrong() const {
  u64 sum = 0;
  for (u32 v = 0; v < kVerdicts; ++v) {
    if (!is_acceptable(static_cast<Verdict>(v))) sum += count(static_cast<Verdict>(v));
  }
  return sum;
}

}  // namespace raywalk::oracle
