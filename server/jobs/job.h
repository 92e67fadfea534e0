// A job as it is seen from outside: a benchmark, or a measurement of accuracy.
#pragma once
#include <exception>
#include <optional>
#include <string>
#include <variant>

#include "server/accuracy/sweep/sweep.h"
#include "server/bench/benchmark.h"

namespace raywalk {

/// What a job is asked for, and what comes out: the same alternative of both.
using JobSpec = std::variant<BenchmarkSpec, accuracy::AccuracySpec>;
using JobResult = std::variant<BenchmarkResult, accuracy::AccuracyResult>;

enum class JobState { queued, running, validating, succeeded, failed, cancelled, interrupted };

/// A snapshot of a job.
struct Job {
  std::string id;
  std::string key;  // Idempotency-Key; empty: none
  JobSpec spec;
  JobState state = JobState::queued;
  u32 attempt = 1;   // grows when the daemon crashed while the job waited
  u32 position = 0;  // jobs before it; 0 when running or ended
  double progress = 0;
  std::string stage = "waiting";
  u64 frames_done = 0, frames_total = 0;
  std::optional<double> eta_s;
  std::exception_ptr error;  // when failed
  std::string created_at, started_at, ended_at;
  u64 version = 1;          // grows with every change
  bool has_result = false;  // its keeper has it

  bool ended() const { return state >= JobState::succeeded; }
};

}  // namespace raywalk
