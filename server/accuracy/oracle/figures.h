// Sums over many judgements.
#pragma once
#include <array>

#include "server/accuracy/oracle/judgement.h"

namespace raywalk::oracle {

/// Errors of t in bins of a sixteenth of an octave, so that its size does not depend on the number of rays.
class UlpHistogram {
 public:
  /// `ulps` is not negative; infinity is allowed.
  void add(double ulps);
  void add(const UlpHistogram& other);
  u64 count() const { return count_; }
  /// The smallest error that at least `fraction` of all do not exceed, up to 7 % too large, never above the largest.
  /// 0 when there is none.
  double percentile(double fraction) const;
  double largest() const { return largest_; }

 private:
  static constexpr i32 kLowestOctave = -10, kHighestOctave = 54, kBinsPerOctave = 16;
  // The first bin holds what lies below the lowest octave, the last what lies above the highest.
  std::array<u64, (kHighestOctave - kLowestOctave) * kBinsPerOctave + 2> bins_{};
  u64 count_ = 0;
  double largest_ = 0;

  static u32 bin_of(double ulps);
};

struct Figures {
  std::array<std::array<u64, kVerdicts>, kRayClasses> counts{};  // [class][verdict]
  UlpHistogram t_ulps;                                           // of all right hits
  UlpHistogram well_conditioned_t_ulps;  // of those where it says something about the arithmetic

  void add(const Judgement& judgement);
  void add(const Figures& other);
  u64 rays() const;
  u64 count(Verdict verdict) const;
  u64 count(RayClass ray_class) const;
  /// Of verdicts that is_acceptable refuses.
  u64 wrong() const;
};

}  // namespace raywalk::oracle
