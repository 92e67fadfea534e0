// Jobs: a bounded queue and the one thread that works it off.
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

#include "server/jobs/job.h"
#include "server/jobs/job_keeper.h"

namespace raywalk {

class JobQueue {
 public:
  using Run = std::function<JobResult(const JobSpec&, const std::function<void(const BenchmarkProgress&)>&)>;
  static constexpr std::size_t kMaxQueued = 64;
  static constexpr std::size_t kMaxEnded = 256;  // of more, those that ended first are forgotten

  /// `kept` are jobs of an earlier daemon, oldest first, queued or ended. Every change of a job's state or stage is
  /// told to `keeper`, which outlives the queue. No job starts once `device_is_lost` (from any thread; empty: never)
  /// says so: those that wait are for the next daemon.
  JobQueue(Run run, JobKeeper& keeper, std::vector<Job> kept = {}, std::function<bool()> device_is_lost = {});
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
  Submitted submit(JobSpec spec, const std::string& key);

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
    u64 end_number = 0;  // counts ends, from 1; 0: not ended
    std::chrono::steady_clock::time_point started, reported;
  };

  void loop();
  void work_on(Entry& entry);
  void report(Entry& entry, const BenchmarkProgress& progress);
  void succeed(Entry& entry, const JobResult& result);
  void finish(Entry& entry, JobState state);
  void keep(const Job& job);
  void note_end(Entry& entry);
  /// Never the one that ended last.
  void forget_old();
  Entry& entry_of(const std::string& id) const;
  Job snapshot(const Entry& entry) const;

  Run run_;
  JobKeeper& keeper_;
  std::function<bool()> device_is_lost_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::condition_variable work_;
  std::deque<std::shared_ptr<Entry>> entries_;  // oldest first; the worker shares the one that it works on
  std::map<std::string, std::string> keys_;     // Idempotency-Key to id
  u64 last_id_ = 0;
  u64 ends_ = 0;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace raywalk
