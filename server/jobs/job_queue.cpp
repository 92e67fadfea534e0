// States of jobs, each told to the keeper, and their one worker.
#include "server/jobs/job_queue.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <random>

#include "server/system/refusal.h"
#include "server/system/time_text.h"

namespace raywalk {
namespace {

constexpr std::chrono::milliseconds kReportInterval{100};

/// Thrown out of a run when its job was cancelled or the daemon stops.
struct Stopped {};

std::string new_id(u64 number) {
  static const u32 start = std::random_device{}();
  char text[32];
  std::snprintf(text, sizeof text, "j%08x-%llu", start, number);
  return text;
}

/// The job once it has ended so.
Job ended_as(Job job, JobState state) {
  job.state = state;
  job.ended_at = now_text();
  job.stage = state == JobState::succeeded ? "done" : state == JobState::failed ? "failed" : "stopped";
  if (state == JobState::succeeded) {
    job.progress = 1;
    job.frames_done = job.frames_total;
  }
  ++job.version;
  return job;
}

}  // namespace

JobQueue::JobQueue(Run run, JobKeeper& keeper, std::vector<Job> kept, std::function<bool()> device_is_lost)
    : run_(std::move(run)), keeper_(keeper), device_is_lost_(std::move(device_is_lost)) {
  std::vector<Entry*> ended;
  for (Job& job : kept) {
    if (!job.key.empty()) keys_[job.key] = job.id;
    entries_.push_back(std::make_shared<Entry>());
    entries_.back()->job = std::move(job);
    if (entries_.back()->job.ended()) ended.push_back(entries_.back().get());
  }
  std::ranges::stable_sort(ended, {}, [](const Entry* entry) -> const std::string& { return entry->job.ended_at; });
  for (Entry* entry : ended) note_end(*entry);
  forget_old();
}

void JobQueue::start() {
  thread_ = std::thread([this] { loop(); });
}

JobQueue::~JobQueue() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  work_.notify_all();
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

JobQueue::Submitted JobQueue::submit(JobSpec spec, const std::string& key) {
  const std::lock_guard lock(mutex_);
  if (const auto known = keys_.find(key); !key.empty() && known != keys_.end()) {
    const Entry& entry = entry_of(known->second);
    if (entry.job.spec == spec) return {snapshot(entry), false};
    throw Refusal(Refusal::Why::conflict, "idempotency_key_reused",
                  "Job '" + entry.job.id + "' of this Idempotency-Key has another spec; take a new key.")
        .at("/spec");
  }
  const auto waiting =
      std::count_if(entries_.begin(), entries_.end(), [](const auto& e) { return e->job.state == JobState::queued; });
  if (static_cast<std::size_t>(waiting) >= kMaxQueued) {
    throw Refusal(Refusal::Why::too_many, "queue_full", "Too many jobs wait; submit again when some have ended.");
  }
  auto entry = std::make_shared<Entry>();
  entry->job.id = new_id(++last_id_);
  entry->job.spec = std::move(spec);
  entry->job.created_at = now_text();
  entry->job.key = key;
  keeper_.keep(entry->job);
  if (!key.empty()) keys_[key] = entry->job.id;
  entries_.push_back(std::move(entry));
  work_.notify_one();
  return {snapshot(*entries_.back()), true};
}

JobQueue::Entry& JobQueue::entry_of(const std::string& id) const {
  for (const auto& entry : entries_) {
    if (entry->job.id == id) return *entry;
  }
  Refusal refusal(Refusal::Why::unknown, "unknown_job", "There is no job '" + id + "'.");
  std::vector<std::string> ids;
  for (const auto& entry : entries_) ids.push_back(entry->job.id);
  throw refusal.known(std::move(ids));
}

Job JobQueue::snapshot(const Entry& entry) const {
  Job job = entry.job;
  if (job.state == JobState::queued) {
    for (const auto& other : entries_) {
      if (other.get() == &entry) break;
      job.position += !other->job.ended();
    }
  }
  if ((job.state == JobState::running || job.state == JobState::validating) && job.progress > 0) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - entry.started;
    job.eta_s = elapsed.count() * (1.0 - job.progress) / job.progress;
  }
  return job;
}

std::vector<Job> JobQueue::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<Job> jobs;
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) jobs.push_back(snapshot(**entry));
  return jobs;
}

Job JobQueue::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  return snapshot(entry_of(id));
}

Job JobQueue::cancel(const std::string& id) {
  const std::lock_guard lock(mutex_);
  Entry& entry = entry_of(id);
  if (entry.job.state == JobState::queued) {
    finish(entry, JobState::cancelled);
    forget_old();
  } else if (!entry.job.ended()) {
    entry.cancel = true;
  }
  return snapshot(entry);
}

Job JobQueue::wait_for_change(const std::string& id, u64 version, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!stopping_ && entry_of(id).job.version <= version) {
    if (changed_.wait_until(lock, deadline) == std::cv_status::timeout) break;
  }
  return snapshot(entry_of(id));
}

std::size_t JobQueue::queued() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(
      std::count_if(entries_.begin(), entries_.end(), [](const auto& e) { return e->job.state == JobState::queued; }));
}

void JobQueue::report(Entry& entry, const BenchmarkProgress& progress) {
  const std::lock_guard lock(mutex_);
  if (entry.cancel || stopping_) throw Stopped{};
  Job& job = entry.job;
  const JobState state = progress.validating ? JobState::validating : JobState::running;
  const auto now = std::chrono::steady_clock::now();
  const bool new_stage = state != job.state || progress.stage != job.stage;
  if (!new_stage && now - entry.reported < kReportInterval) return;
  entry.reported = now;
  job.state = state;
  job.stage = progress.stage;
  job.progress = progress.fraction;
  job.frames_done = progress.frames_done;
  job.frames_total = progress.frames_total;
  ++job.version;
  if (new_stage) keep(job);
  changed_.notify_all();
}

void JobQueue::keep(const Job& job) {
  try {
    keeper_.keep(job);
  } catch (const std::exception& e) {
    spdlog::error("job {} would not be known after a restart: {}", job.id, e.what());
  }
}

void JobQueue::finish(Entry& entry, JobState state) {
  entry.job = ended_as(std::move(entry.job), state);
  note_end(entry);
  keep(entry.job);
  changed_.notify_all();
}

void JobQueue::note_end(Entry& entry) {
  entry.end_number = ++ends_;
}

void JobQueue::forget_old() {
  const auto is_ended = [](const auto& entry) { return entry->job.ended(); };
  auto ended = static_cast<std::size_t>(std::ranges::count_if(entries_, is_ended));
  for (; ended > kMaxEnded; --ended) {
    const auto first = std::ranges::min_element(entries_, {}, [](const auto& entry) {
      return entry->job.ended() ? entry->end_number : std::numeric_limits<u64>::max();
    });
    const Job& job = (*first)->job;
    if (!job.key.empty()) keys_.erase(job.key);
    try {
      keeper_.forget(job.id);
    } catch (const std::exception& e) {
      spdlog::error("job {} stays in the store: {}", job.id, e.what());
    }
    entries_.erase(first);
  }
}

/// Writing a large result takes its time: the queue is not locked meanwhile.
void JobQueue::succeed(Entry& entry, const JobResult& result) {
  std::unique_lock lock(mutex_);
  Job done = ended_as(entry.job, JobState::succeeded);
  lock.unlock();
  done.has_result = true;
  keeper_.keep(done, result);
  lock.lock();
  entry.job = std::move(done);
  note_end(entry);
  changed_.notify_all();
}

void JobQueue::work_on(Entry& entry) {
  std::exception_ptr error;
  try {
    succeed(entry, run_(entry.job.spec, [&](const BenchmarkProgress& progress) { report(entry, progress); }));
  } catch (const Stopped&) {
  } catch (const std::exception& e) {
    spdlog::warn("job {} failed: {}", entry.job.id, e.what());
    error = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  if (!entry.job.ended()) {
    entry.job.error = error;
    finish(entry, error ? JobState::failed : entry.cancel ? JobState::cancelled : JobState::interrupted);
  }
  spdlog::info("job {} ended", entry.job.id);
  forget_old();
}

void JobQueue::loop() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    const auto next =
        std::find_if(entries_.begin(), entries_.end(), [](const auto& e) { return e->job.state == JobState::queued; });
    if (next == entries_.end() || (device_is_lost_ && device_is_lost_())) {
      work_.wait(lock);
      continue;
    }
    const std::shared_ptr<Entry> entry = *next;
    entry->job.state = JobState::running;
    entry->job.stage = "starting";
    entry->job.started_at = now_text();
    entry->started = std::chrono::steady_clock::now();
    ++entry->job.version;
    keep(entry->job);
    changed_.notify_all();
    lock.unlock();
    spdlog::info("job {} started: scene={}", entry->job.id,
                 std::visit([](const auto& spec) -> const std::string& { return spec.scene; }, entry->job.spec));
    work_on(*entry);
    lock.lock();
  }
}

}  // namespace raywalk
