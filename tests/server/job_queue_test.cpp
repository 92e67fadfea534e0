// States of jobs, keys, bounds, cancelling.
#include "server/bench/job_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>

#include "server/system/refusal.h"

namespace raywalk {
namespace {

using namespace std::chrono_literals;
using Report = std::function<void(const BenchmarkProgress&)>;

Job wait_for_end(const JobQueue& jobs, const std::string& id) {
  Job job = jobs.find(id);
  while (!job.ended()) job = jobs.wait_for_change(id, job.version, 1s);
  return job;
}

/// Reports until it is stopped.
BenchmarkResult endless(const BenchmarkSpec&, const Report& report) {
  for (double done = 0;; done += 0.001) {
    report({"measuring", false, done, 1, 2});
    std::this_thread::sleep_for(1ms);
  }
}

TEST(JobQueue, SucceedsWithAResult) {
  JobQueue jobs([](const BenchmarkSpec&, const Report& report) {
    report({"a", false, 0.5, 1, 2});
    report({"b", true, 0.9, 2, 2});
    return BenchmarkResult{};
  });
  const auto submitted = jobs.submit({}, "");
  EXPECT_TRUE(submitted.fresh);
  const Job job = wait_for_end(jobs, submitted.job.id);
  EXPECT_EQ(job.state, JobState::succeeded);
  EXPECT_EQ(job.progress, 1.0);
  EXPECT_TRUE(job.result);
  EXPECT_FALSE(job.ended_at.empty());
}

TEST(JobQueue, FailsWithItsCause) {
  JobQueue jobs([](const BenchmarkSpec&, const Report&) -> BenchmarkResult { throw std::runtime_error("no memory"); });
  const Job job = wait_for_end(jobs, jobs.submit({}, "").job.id);
  EXPECT_EQ(job.state, JobState::failed);
  EXPECT_FALSE(job.result);
  EXPECT_THROW(std::rethrow_exception(job.error), std::runtime_error);
}

TEST(JobQueue, TheSameKeyIsTheSameJob) {
  JobQueue jobs([](const BenchmarkSpec&, const Report&) { return BenchmarkResult{}; });
  const auto first = jobs.submit({}, "k"), second = jobs.submit({}, "k"), other = jobs.submit({}, "");
  EXPECT_FALSE(second.fresh);
  EXPECT_EQ(second.job.id, first.job.id);
  EXPECT_NE(other.job.id, first.job.id);
}

TEST(JobQueue, AKeyStandsForOneSpec) {
  JobQueue jobs([](const BenchmarkSpec&, const Report&) { return BenchmarkResult{}; });
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
  JobQueue jobs([&](const BenchmarkSpec&, const Report& report) {
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
  JobQueue jobs(endless);
  const std::string running = jobs.submit({}, "").job.id, waiting = jobs.submit({}, "").job.id;
  EXPECT_EQ(jobs.cancel(waiting).state, JobState::cancelled);
  jobs.wait_for_change(running, 2, 5s);
  jobs.cancel(running);
  EXPECT_EQ(wait_for_end(jobs, running).state, JobState::cancelled);
  EXPECT_EQ(jobs.cancel(running).state, JobState::cancelled);
}

TEST(JobQueue, IsBounded) {
  JobQueue jobs(endless);
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
    JobQueue jobs(endless);
    jobs.submit({}, "");
    jobs.submit({}, "");
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
}

TEST(JobQueue, UnknownJob) {
  JobQueue jobs(endless);
  EXPECT_THROW(jobs.find("x"), Refusal);
  EXPECT_THROW(jobs.cancel("x"), Refusal);
}

}  // namespace
}  // namespace raywalk
