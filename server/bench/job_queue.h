// Benchmark jobs: a bounded queue and the one thread that works it off.
#pragma once
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "server/bench/benchmark.h"
#include "server/bench/job.h"
#include "server/bench/job_keeper.h"

namespace raywalk {

class JobQueue {
 public:
  using Run =
      std::function<BenchmarkResult(const BenchmarkSpec&, const std::function<void(const BenchmarkProgress&)>&)>;
  static constexpr std::size_t kMaxQueued = 64;
  static constexpr std::size_t kMaxEnded = 256;  // the oldest of more are forgotten

  /// `kept` are jobs of an earlier daemon, oldest first, queued or ended. Every change of a job's state or stage is
  /// told to `keeper`, which outlives the queue.
  JobQueue(Run run, JobKeeper& keeper, std::vector<Job> kept = {});
  /// The job that runs ends as interrupted at its next frame; those that wait are kept as they are.
  ~JobQueue();
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  /// Begins to work; jobs only wait before.
  void start();

  struct Submitted {
    Job job;
    bool fresh;  // false: a job with this key was there
  };
  /// `key` may be empty. Throws Refusal queue_full, idempotency_key_reused for another spec under a known key, and what
  /// the keeper throws.
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
    bool cancel = false;
    std::chrono::steady_clock::time_point started, reported;
  };

  void loop();
  void work_on(Entry& entry);
  void report(Entry& entry, const BenchmarkProgress& progress);
  void succeed(Entry& entry, const BenchmarkResult& result);
  void finish(Entry& entry, JobState state);
  void keep(const Job& job);
  void forget_old();
  Entry& entry_of(const std::string& id) const;
  Job snapshot(const Entry& entry) const;

  Run run_;
  JobKeeper& keeper_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::condition_variable work_;
  std::deque<std::unique_ptr<Entry>> entries_;  // oldest first
  std::map<std::string, std::string> keys_;     // Idempotency-Key to id
  u64 last_id_ = 0;
  bool stopping_ = false;
  bool device_lost_ = false;  // jobs that wait are for the next daemon
  std::thread thread_;
};

}  // namespace raywalk
