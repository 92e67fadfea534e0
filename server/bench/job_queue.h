// Benchmark jobs: a bounded queue in memory and the one thread that works it off.
#pragma once
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "server/bench/benchmark.h"

namespace raywalk {

enum class JobState { queued, running, validating, succeeded, failed, cancelled, interrupted };

/// A snapshot of a job.
struct Job {
  std::string id;
  BenchmarkSpec spec;
  JobState state = JobState::queued;
  u32 position = 0;  // jobs before it; 0 when running or ended
  double progress = 0;
  std::string stage = "waiting";
  u64 frames_done = 0, frames_total = 0;
  std::optional<double> eta_s;
  std::exception_ptr error;  // when failed
  std::string created_at, started_at, ended_at;
  u64 version = 1;  // grows with every change
  std::shared_ptr<const BenchmarkResult> result;

  bool ended() const { return state >= JobState::succeeded; }
};

class JobQueue {
 public:
  using Run =
      std::function<BenchmarkResult(const BenchmarkSpec&, const std::function<void(const BenchmarkProgress&)>&)>;
  static constexpr std::size_t kMaxQueued = 64;
  static constexpr std::size_t kMaxEnded = 256;  // the oldest of more are forgotten

  explicit JobQueue(Run run);
  /// The job that runs ends as interrupted at its next frame.
  ~JobQueue();
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  struct Submitted {
    Job job;
    bool fresh;  // false: a job with this key was there
  };
  /// `key` may be empty. Throws Refusal queue_full, idempotency_key_reused for another spec under a known key.
  Submitted submit(BenchmarkSpec spec, const std::string& key);

  /// Newest first.
  std::vector<Job> list() const;
  /// Throws Refusal unknown_job.
  Job find(const std::string& id) const;
  Job cancel(const std::string& id);
  /// The job once its version is past `version`, or as it is after `patience`. Throws Refusal unknown_job.
  Job wait_for_change(const std::string& id, u64 version, std::chrono::milliseconds patience) const;

  std::size_t queued() const;

 private:
  struct Entry {
    Job job;
    std::string key;
    bool cancel = false;
    std::chrono::steady_clock::time_point started, reported;
  };

  void loop();
  void work_on(Entry& entry);
  void report(Entry& entry, const BenchmarkProgress& progress);
  void finish(Entry& entry, JobState state);
  void forget_old();
  Entry& entry_of(const std::string& id) const;
  Job snapshot(const Entry& entry) const;

  Run run_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::condition_variable work_;
  std::deque<std::unique_ptr<Entry>> entries_;  // oldest first
  std::map<std::string, std::string> keys_;     // Idempotency-Key to id
  u64 last_id_ = 0;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace raywalk
