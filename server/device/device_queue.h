// The one thread that may touch the device; everybody else sends it work and waits.
#pragma once
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>

#include "server/device/device.h"

namespace raywalk {

/// Too much waits already, or a benchmark holds the device for longer than a caller should wait.
class DeviceBusy : public std::runtime_error {
 public:
  /// `code` is "busy" or "device_busy".
  DeviceBusy(std::string code, const std::string& what) : std::runtime_error(what), code_(std::move(code)) {}
  const std::string& code() const { return code_; }

 private:
  std::string code_;
};

class DeviceQueue {
 public:
  struct Config {
    std::size_t capacity = 64;                    // tasks that may wait
    std::chrono::milliseconds held_wait{10'000};  // how long `run` waits while the device is held
    /// Called once, from the device's thread, when work throws DeviceLost or `tell_lost` is called.
    std::function<void(const std::string& cause)> on_lost = {};
  };
  class Hold;

  explicit DeviceQueue(Device& device) : DeviceQueue(device, Config{}) {}
  DeviceQueue(Device& device, Config config);
  /// Finishes the task that runs; those that wait end with DeviceBusy.
  ~DeviceQueue();
  DeviceQueue(const DeviceQueue&) = delete;
  DeviceQueue& operator=(const DeviceQueue&) = delete;

  /// For what may be asked from any thread.
  const Device& device() const { return device_; }

  /// Runs `work(device)` on the device thread; returns its value or rethrows. `queue_ms` gets the time it waited.
  /// Throws DeviceBusy, and DeviceLost without running anything once the device is lost.
  template <class Work>
  auto run(Work&& work, double* queue_ms = nullptr) {
    return run_as(nullptr, std::forward<Work>(work), queue_ms);
  }

  /// Queues `work`, which must not throw, and returns. Throws DeviceBusy when the queue is full, and DeviceLost.
  void post(std::function<void(Device&)> work);

  /// Takes the device for one holder alone, after what runs now; waits for another hold to end.
  Hold hold();

  /// For work that keeps a DeviceLost to itself.
  void tell_lost(const std::string& cause);
  /// Why the device cannot be used any more; nothing while it can.
  std::optional<std::string> lost() const;

  /// Tasks that wait.
  std::size_t depth() const;

 private:
  enum class State { waiting, running, done };
  struct Task {
    std::function<void(Device&)> work;
    std::function<void(const DeviceBusy&)> refuse;  // instead of work, when the queue ends
    const Hold* owner = nullptr;
    State state = State::waiting;
    std::chrono::steady_clock::time_point queued = std::chrono::steady_clock::now();
    double queue_ms = 0;
  };

  template <class Work>
  auto run_as(const Hold* owner, Work&& work, double* queue_ms) {
    using Value = std::invoke_result_t<Work, Device&>;
    std::exception_ptr error;
    auto task = std::make_shared<Task>();
    task->owner = owner;
    task->refuse = [&error](const DeviceBusy& busy) { error = std::make_exception_ptr(busy); };
    const auto finish = [&] {
      enqueue_and_wait(task);
      if (queue_ms != nullptr) *queue_ms = task->queue_ms;
      if (error) std::rethrow_exception(error);
    };
    if constexpr (std::is_void_v<Value>) {
      task->work = [&](Device& device) { error = error_of([&] { work(device); }); };
      finish();
    } else {
      std::optional<Value> value;
      task->work = [&](Device& device) { error = error_of([&] { value.emplace(work(device)); }); };
      finish();
      return std::move(*value);
    }
  }

  template <class Act>
  std::exception_ptr error_of(Act act) {
    try {
      act();
    } catch (const DeviceLost& lost) {
      tell_lost(lost.what());
      return std::current_exception();
    } catch (...) {
      return std::current_exception();
    }
    return nullptr;
  }

  void enqueue_and_wait(const std::shared_ptr<Task>& task);
  void admit(std::unique_lock<std::mutex>& lock, const std::shared_ptr<Task>& task);
  std::shared_ptr<Task> next();
  void loop();
  void release();

  Device& device_;
  Config config_;
  mutable std::mutex mutex_;
  std::condition_variable work_, done_;
  std::deque<std::shared_ptr<Task>> tasks_;
  const Hold* holder_ = nullptr;
  bool stopping_ = false;
  std::optional<std::string> lost_;
  std::thread thread_;
};

/// While it lives, the device runs only this holder's work.
class DeviceQueue::Hold {
 public:
  ~Hold() { queue_.release(); }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

  template <class Work>
  auto run(Work&& work) {
    return queue_.run_as(this, std::forward<Work>(work), nullptr);
  }

 private:
  friend class DeviceQueue;
  /// The queue is locked by the caller.
  explicit Hold(DeviceQueue& queue) : queue_(queue) {
    queue.holder_ = this;
    queue.done_.notify_all();  // those that wait begin to count
  }
  DeviceQueue& queue_;
};

}  // namespace raywalk
