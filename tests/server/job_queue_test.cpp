// States of jobs, keys, bounds, cancelling.
#include "server/jobs/job_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <map>

#include "server/device/device_queue.h"
#include "server/system/refusal.h"
#include "tests/server/fake_device.h"

namespace raywalk {
namespace {

using namespace std::chrono_literals;
using Report = std::function<void(const BenchmarkProgress&)>;

/// What was kept last, and which results.
class MemoryKeeper : public JobKeeper {
 public:
  void keep(const Job& job) override {
    const std::lock_guard lock(mutex_);
    if (full) throw Refusal(Refusal::Why::unavailable, "storage_failed", "The disk is full.");
    jobs_[job.id] = job;
  }
  void keep(const Job& job, const JobResult& result) override {
    keep(job);
    const std::lock_guard lock(mutex_);
    results_[job.id] = std::visit([](const auto& one) { return one.created_at; }, result);
  }
  void forget(const std::string& id) override {
    const std::lock_guard lock(mutex_);
    jobs_.erase(id);
    results_.erase(id);
  }
  Job job(const std::string& id) const {
    const std::lock_guard lock(mutex_);
    return jobs_.at(id);
  }
  std::map<std::string, std::string> results() const {
    const std::lock_guard lock(mutex_);
    return results_;
  }
  std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return jobs_.size();
  }

  std::atomic<bool> full{false};

 private:
  mutable std::mutex mutex_;
  std::map<std::string, Job> jobs_;
  std::map<std::string, std::string> results_;  // their dates
};

/// A queue that works, with a keeper of its own.
class WorkingQueue : private MemoryKeeper, public JobQueue {
 public:
  explicit WorkingQueue(Run run) : JobQueue(std::move(run), *this) { start(); }
  MemoryKeeper& keeper() { return *this; }
};

Job wait_for_end(const JobQueue& jobs, const std::string& id) {
  Job job = jobs.find(id);
  while (!job.ended()) job = jobs.wait_for_change(id, job.version, 1s);
  return job;
}

/// Reports until it is stopped.
BenchmarkResult endless(const JobSpec&, const Report& report) {
  for (double done = 0;; done += 0.001) {
    report({"measuring", false, done, 1, 2});
    std::this_thread::sleep_for(1ms);
  }
}

TEST(JobQueue, SucceedsWithAResult) {
  WorkingQueue jobs([](const JobSpec&, const Report& report) {
    report({"a", false, 0.5, 1, 2});
    report({"b", true, 0.9, 2, 2});
    return BenchmarkResult{};
  });
  const auto submitted = jobs.submit({}, "");
  EXPECT_TRUE(submitted.fresh);
  const Job job = wait_for_end(jobs, submitted.job.id);
  EXPECT_EQ(job.state, JobState::succeeded);
  EXPECT_EQ(job.progress, 1.0);
  EXPECT_TRUE(job.has_result);
  EXPECT_FALSE(job.ended_at.empty());
}

TEST(JobQueue, FailsWithItsCause) {
  WorkingQueue jobs([](const JobSpec&, const Report&) -> BenchmarkResult { throw std::runtime_error("no memory"); });
  const Job job = wait_for_end(jobs, jobs.submit({}, "").job.id);
  EXPECT_EQ(job.state, JobState::failed);
  EXPECT_FALSE(job.has_result);
  EXPECT_THROW(std::rethrow_exception(job.error), std::runtime_error);
}

TEST(JobQueue, TheSameKeyIsTheSameJob) {
  WorkingQueue jobs([](const JobSpec&, const Report&) { return BenchmarkResult{}; });
  const auto first = jobs.submit({}, "k"), second = jobs.submit({}, "k"), other = jobs.submit({}, "");
  EXPECT_FALSE(second.fresh);
  EXPECT_EQ(second.job.id, first.job.id);
  EXPECT_NE(other.job.id, first.job.id);
}

TEST(JobQueue, AKeyStandsForOneSpec) {
  WorkingQueue jobs([](const JobSpec&, const Report&) { return BenchmarkResult{}; });
  jobs.submit({}, "k");
  BenchmarkSpec other;
  other.frames = 7;
  try {
    jobs.submit(other, "k");
    FAIL() << "the key should be taken";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.code(), "idempotency_key_reused");
  }
}

TEST(JobQueue, EveryStageIsSeen) {
  std::vector<std::string> seen;
  JobQueue* queue = nullptr;
  WorkingQueue jobs([&](const JobSpec&, const Report& report) {
    for (const char* stage : {"loading", "building", "warming up", "measuring"}) {
      for (int i = 0; i < 3; ++i) report({stage, false, 0.1, 1, 2});
      seen.push_back(queue->list().front().stage);
    }
    return BenchmarkResult{};
  });
  queue = &jobs;
  wait_for_end(jobs, jobs.submit({}, "").job.id);
  EXPECT_EQ(seen, (std::vector<std::string>{"loading", "building", "warming up", "measuring"}));
}

TEST(JobQueue, CancelsWhatRunsAndWhatWaits) {
  WorkingQueue jobs(endless);
  const std::string running = jobs.submit({}, "").job.id, waiting = jobs.submit({}, "").job.id;
  EXPECT_EQ(jobs.cancel(waiting).state, JobState::cancelled);
  jobs.wait_for_change(running, 2, 5s);
  jobs.cancel(running);
  EXPECT_EQ(wait_for_end(jobs, running).state, JobState::cancelled);
  EXPECT_EQ(jobs.cancel(running).state, JobState::cancelled);
}

TEST(JobQueue, IsBounded) {
  WorkingQueue jobs(endless);
  const std::string running = jobs.submit({}, "").job.id;
  while (jobs.find(running).state == JobState::queued) std::this_thread::sleep_for(1ms);
  for (std::size_t i = 0; i < JobQueue::kMaxQueued; ++i) EXPECT_EQ(jobs.submit({}, "").job.position, i + 1);
  try {
    jobs.submit({}, "");
    FAIL() << "the queue should be full";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.why(), Refusal::Why::too_many);
  }
  EXPECT_EQ(jobs.queued(), JobQueue::kMaxQueued);
}

TEST(JobQueue, EndsWithoutWaitingForItsJobs) {
  const auto begin = std::chrono::steady_clock::now();
  {
    WorkingQueue jobs(endless);
    jobs.submit({}, "");
    jobs.submit({}, "");
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
}

TEST(JobQueue, KeepsEveryStateAndTheResult) {
  WorkingQueue* queue = nullptr;
  std::vector<std::string> kept;
  WorkingQueue jobs([&](const JobSpec&, const Report& report) {
    const std::string id = queue->list().front().id;
    kept.push_back(queue->keeper().job(id).stage);
    report({"measuring", false, 0.5, 1, 2});
    kept.push_back(queue->keeper().job(id).stage);
    BenchmarkResult result;
    result.created_at = "today";
    return result;
  });
  queue = &jobs;
  const std::string id = wait_for_end(jobs, jobs.submit({}, "k").job.id).id;
  EXPECT_EQ(kept, (std::vector<std::string>{"starting", "measuring"}));
  const Job job = jobs.keeper().job(id);
  EXPECT_EQ(job.state, JobState::succeeded);
  EXPECT_EQ(job.key, "k");
  EXPECT_TRUE(job.has_result);
  EXPECT_EQ(jobs.keeper().results().at(id), "today");
}

TEST(JobQueue, AJobThatCannotBeKeptIsRefused) {
  WorkingQueue jobs([](const JobSpec&, const Report&) { return BenchmarkResult{}; });
  jobs.keeper().full = true;
  EXPECT_THROW(jobs.submit({}, "k"), Refusal);
  EXPECT_TRUE(jobs.list().empty());
  jobs.keeper().full = false;
  EXPECT_TRUE(jobs.submit({}, "k").fresh) << "the key was not taken";
}

TEST(JobQueue, AResultThatCannotBeKeptFailsItsJob) {
  WorkingQueue* queue = nullptr;
  WorkingQueue jobs([&](const JobSpec&, const Report&) {
    queue->keeper().full = true;
    return BenchmarkResult{};
  });
  queue = &jobs;
  const Job job = wait_for_end(jobs, jobs.submit({}, "").job.id);
  EXPECT_EQ(job.state, JobState::failed);
  EXPECT_FALSE(job.has_result);
  EXPECT_THROW(std::rethrow_exception(job.error), Refusal);
}

TEST(JobQueue, GoesOnWithKeptJobs) {
  std::vector<Job> kept(3);
  const char* ids[] = {"a", "b", "c"};
  for (int i = 0; i < 3; ++i) kept[i].id = ids[i];
  kept[0].state = JobState::succeeded;
  kept[0].key = "k";
  std::get<BenchmarkSpec>(kept[1].spec).frames = 1;
  std::get<BenchmarkSpec>(kept[2].spec).frames = 2;
  std::vector<u32> run;
  MemoryKeeper keeper;
  JobQueue jobs(
      [&](const JobSpec& spec, const Report&) {
        run.push_back(std::get<BenchmarkSpec>(spec).frames);
        return BenchmarkResult{};
      },
      keeper, kept);
  EXPECT_EQ(jobs.submit({}, "k").job.id, "a");
  EXPECT_EQ(jobs.find("c").position, 1u);
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(jobs.queued(), 2u) << "nothing runs before start()";
  jobs.start();
  wait_for_end(jobs, "b");
  wait_for_end(jobs, "c");
  EXPECT_EQ(run, (std::vector<u32>{1, 2}));
}

TEST(JobQueue, WhatWaitsAtTheEndIsKeptAsQueued) {
  MemoryKeeper keeper;
  std::string running, waiting;
  {
    JobQueue jobs(endless, keeper);
    jobs.start();
    running = jobs.submit({}, "").job.id;
    waiting = jobs.submit({}, "").job.id;
    jobs.wait_for_change(running, 2, 5s);
  }
  EXPECT_EQ(keeper.job(running).state, JobState::interrupted);
  EXPECT_EQ(keeper.job(waiting).state, JobState::queued);
}

TEST(JobQueue, ALostDeviceRunsNothingMore) {
  MemoryKeeper keeper;
  std::atomic<bool> lost{false};
  JobQueue jobs(
      [&](const JobSpec&, const Report&) -> BenchmarkResult {
        lost = true;
        throw DeviceLost("it trapped");
      },
      keeper, {}, [&] { return lost.load(); });
  const std::string first = jobs.submit({}, "").job.id, second = jobs.submit({}, "").job.id;
  jobs.start();
  EXPECT_EQ(wait_for_end(jobs, first).state, JobState::failed);
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(jobs.find(second).state, JobState::queued);
}

TEST(JobQueue, NothingStartsOnADeviceThatOthersLost) {
  test::FakeDevice device;
  DeviceQueue devices(device);
  MemoryKeeper keeper;
  std::atomic<int> runs{0};
  JobQueue jobs(
      [&](const JobSpec&, const Report&) {
        ++runs;
        return BenchmarkResult{};
      },
      keeper, {}, [&] { return devices.lost().has_value(); });
  jobs.start();
  device.is_lost = true;
  Frame frame;
  EXPECT_THROW(devices.run([&](Device& d) { d.render({}, frame); }), DeviceLost);
  const std::string waiting = jobs.submit({}, "").job.id;
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(keeper.job(waiting).state, JobState::queued) << "it is for the next daemon";
  EXPECT_EQ(runs, 0);
}

TEST(JobQueue, ManyCancelledJobsDoNotPushOutTheOneThatRan) {
  std::atomic<bool> go_on{false};
  WorkingQueue jobs([&](const JobSpec&, const Report&) {
    while (!go_on) std::this_thread::sleep_for(1ms);
    return BenchmarkResult{};
  });
  const std::string running = jobs.submit({}, "").job.id;
  while (jobs.find(running).state == JobState::queued) std::this_thread::sleep_for(1ms);
  std::vector<std::string> cancelled;
  for (std::size_t i = 0; i < JobQueue::kMaxEnded + 3; ++i) {
    cancelled.push_back(jobs.submit({}, "").job.id);
    EXPECT_EQ(jobs.cancel(cancelled.back()).state, JobState::cancelled);
  }
  EXPECT_EQ(jobs.list().size(), JobQueue::kMaxEnded + 1) << "cancelling forgets too";
  go_on = true;
  EXPECT_EQ(wait_for_end(jobs, running).state, JobState::succeeded);
  const std::string next = jobs.submit({}, "").job.id;
  EXPECT_EQ(wait_for_end(jobs, next).state, JobState::succeeded) << "the queue still works";
  EXPECT_TRUE(jobs.keeper().results().contains(running)) << "its result is kept";
  EXPECT_TRUE(jobs.find(running).has_result);
  EXPECT_THROW(jobs.find(cancelled[3]), Refusal) << "those that ended first are forgotten";
  EXPECT_NO_THROW(jobs.find(cancelled.back()));
}

TEST(JobQueue, WhatEndedFirstIsForgottenFirst) {
  std::vector<Job> kept(JobQueue::kMaxEnded + 1);
  MemoryKeeper keeper;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i].id = std::to_string(i);
    kept[i].state = JobState::succeeded;
    kept[i].ended_at = i == 0   ? "2026-01-02T00:00:00.000Z"
                       : i == 7 ? "2025-01-01T00:00:00.000Z"
                                : "2026-01-01T00:00:00.000Z";
  }
  const JobQueue jobs([](const JobSpec&, const Report&) { return BenchmarkResult{}; }, keeper, kept);
  EXPECT_NO_THROW(jobs.find("0")) << "submitted first, and ended last";
  EXPECT_THROW(jobs.find("7"), Refusal);
}

TEST(JobQueue, TheOldestAreForgotten) {
  std::vector<Job> kept(JobQueue::kMaxEnded + 5);
  MemoryKeeper keeper;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i].id = std::to_string(i);
    kept[i].state = JobState::cancelled;
    keeper.keep(kept[i]);
  }
  const JobQueue jobs([](const JobSpec&, const Report&) { return BenchmarkResult{}; }, keeper, kept);
  EXPECT_EQ(jobs.list().size(), JobQueue::kMaxEnded);
  EXPECT_EQ(keeper.size(), JobQueue::kMaxEnded);
  EXPECT_THROW(jobs.find("4"), Refusal);
  EXPECT_NO_THROW(jobs.find("5"));
}

TEST(JobQueue, UnknownJob) {
  WorkingQueue jobs(endless);
  EXPECT_THROW(jobs.find("x"), Refusal);
  EXPECT_THROW(jobs.cancel("x"), Refusal);
}

}  // namespace
}  // namespace raywalk
