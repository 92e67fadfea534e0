// Scheduling of the device thread: first come, first served, except while somebody holds the device.
#include "server/device/device_queue.h"

#include <algorithm>

namespace raywalk {

DeviceQueue::DeviceQueue(Device& device, Config config)
    : device_(device), config_(config), thread_([this] { loop(); }) {}

DeviceQueue::~DeviceQueue() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  work_.notify_all();
  done_.notify_all();
  thread_.join();
}

void DeviceQueue::admit(std::unique_lock<std::mutex>&, const std::shared_ptr<Task>& task) {
  if (stopping_) throw DeviceBusy("busy", "The daemon is stopping.");
  if (lost_) throw DeviceLost(*lost_);
  if (task->owner == nullptr && tasks_.size() >= config_.capacity) {
    throw DeviceBusy("busy", "Too many requests wait for the device; try again later.");
  }
  tasks_.push_back(task);
  work_.notify_one();
}

void DeviceQueue::post(std::function<void(Device&)> work) {
  auto task = std::make_shared<Task>();
  task->work = std::move(work);
  task->refuse = [](const DeviceBusy&) {};
  std::unique_lock lock(mutex_);
  admit(lock, task);
}

void DeviceQueue::enqueue_and_wait(const std::shared_ptr<Task>& task) {
  std::unique_lock lock(mutex_);
  admit(lock, task);
  const auto deadline = task->queued + config_.held_wait;
  while (task->state != State::done) {
    const bool shut_out = task->state == State::waiting && holder_ != nullptr && holder_ != task->owner;
    if (shut_out && std::chrono::steady_clock::now() >= deadline) {
      std::erase(tasks_, task);
      throw DeviceBusy("device_busy", "A benchmark holds the device; try again when it has ended.");
    }
    if (shut_out) {
      done_.wait_until(lock, deadline);
    } else {
      done_.wait(lock);
    }
  }
}

DeviceQueue::Hold DeviceQueue::hold() {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return holder_ == nullptr || stopping_; });
  if (stopping_) throw DeviceBusy("busy", "The daemon is stopping.");
  return Hold(*this);  // the constructor registers it: guaranteed elision, so its address stays
}

void DeviceQueue::release() {
  {
    const std::lock_guard lock(mutex_);
    holder_ = nullptr;
  }
  work_.notify_all();
  done_.notify_all();
}

void DeviceQueue::tell_lost(const std::string& cause) {
  {
    const std::lock_guard lock(mutex_);
    if (lost_) return;
    lost_ = cause;
  }
  if (config_.on_lost) config_.on_lost(cause);
}

std::optional<std::string> DeviceQueue::lost() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

std::size_t DeviceQueue::depth() const {
  const std::lock_guard lock(mutex_);
  return tasks_.size();
}

std::shared_ptr<DeviceQueue::Task> DeviceQueue::next() {
  const auto found = std::find_if(tasks_.begin(), tasks_.end(), [this](const std::shared_ptr<Task>& task) {
    return holder_ == nullptr || task->owner == holder_;
  });
  if (found == tasks_.end()) return nullptr;
  std::shared_ptr<Task> task = *found;
  tasks_.erase(found);
  return task;
}

void DeviceQueue::loop() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    const std::shared_ptr<Task> task = next();
    if (!task) {
      work_.wait(lock);
      continue;
    }
    task->state = State::running;
    task->queue_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - task->queued).count();
    lock.unlock();
    task->work(device_);
    task->work = nullptr;  // drops what the work holds, on this thread
    lock.lock();
    task->state = State::done;
    done_.notify_all();
  }
  for (const std::shared_ptr<Task>& task : tasks_) {
    task->refuse(DeviceBusy("busy", "The daemon is stopping."));
    task->state = State::done;
  }
  tasks_.clear();
  done_.notify_all();
}

}  // namespace raywalk
