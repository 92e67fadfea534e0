// What the parts of a run share: where it works, how far it is, and when it must end.
#pragma once
#include <chrono>

#include "server/accuracy/sweep/sweep.h"

namespace raywalk::accuracy {

class Run {
 public:
  Run(const AccuracySpec& its_spec, const Workplace& its_place,
      const std::function<void(const BenchmarkProgress&)>& report)
      : spec(its_spec), place(its_place), report_(report) {}

  const AccuracySpec& spec;
  const Workplace& place;

  bool on_gpu() const { return place.queue.device().info().kind != "cpu"; }
  double seconds_left() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    return spec.time_limit_s - elapsed.count();
  }
  /// What follows is the part of the whole from `from` to `to`.
  void enter(double from, double to) {
    from_ = from;
    to_ = to;
  }
  /// `fraction` of the part that was entered. Throws what ends the run.
  void report(const std::string& stage, double fraction, bool validating = false) const {
    report_({stage, validating, from_ + (to_ - from_) * fraction, 0, 0});
  }

 private:
  const std::function<void(const BenchmarkProgress&)>& report_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double from_ = 0, to_ = 1;
};

/// The part of the hard cases; fills `out.cases`.
void run_cases(Run& run, AccuracyResult& out);

/// The part of the scene; fills everything else of `out` but date and machine.
void run_sweep(Run& run, AccuracyResult& out);

}  // namespace raywalk::accuracy
