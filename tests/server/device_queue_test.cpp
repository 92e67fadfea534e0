// The device thread: order, exceptions, bounds, holds.
#include "server/device/device_queue.h"

#include <gtest/gtest.h>

#include <future>
#include <set>

#include "tests/server/fake_device.h"

namespace raywalk {
namespace {

using namespace std::chrono_literals;

/// Keeps the device busy until it is let go.
class Blocker {
 public:
  explicit Blocker(DeviceQueue& queue) {
    std::promise<void> running;
    queue.post([this, &running](Device&) {
      running.set_value();
      gate_.get_future().wait();
    });
    running.get_future().wait();
  }
  void release() { gate_.set_value(); }

 private:
  std::promise<void> gate_;
};

void wait_for_depth(const DeviceQueue& queue, std::size_t depth) {
  while (queue.depth() != depth) std::this_thread::sleep_for(1ms);
}

TEST(DeviceQueue, RunsOnOneThreadAndReturnsValues) {
  test::FakeDevice device;
  DeviceQueue queue(device);
  std::set<std::thread::id> threads;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(queue.run([&](Device& d) {
      threads.insert(std::this_thread::get_id());
      return d.info().name + std::to_string(i);
    }),
              "fake" + std::to_string(i));
  }
  EXPECT_EQ(threads.size(), 1u);
  EXPECT_FALSE(threads.contains(std::this_thread::get_id()));
}

TEST(DeviceQueue, RethrowsAndGoesOn) {
  test::FakeDevice device;
  DeviceQueue queue(device);
  EXPECT_THROW(queue.run([](Device&) { throw std::invalid_argument("bad"); }), std::invalid_argument);
  EXPECT_EQ(queue.run([](Device&) { return 3; }), 3);
}

TEST(DeviceQueue, TellsOnceThatTheDeviceIsLost) {
  test::FakeDevice device;
  int told = 0;
  DeviceQueue queue(device, {.on_lost = [&](const std::string& cause) {
                      ++told;
                      EXPECT_EQ(cause, "a fault");
                    }});
  EXPECT_FALSE(queue.lost());
  EXPECT_THROW(queue.run([](Device&) { throw DeviceLost("a fault"); }), DeviceLost);
  bool ran = false;
  EXPECT_THROW(queue.run([&](Device&) { ran = true; }), DeviceLost);
  EXPECT_THROW(queue.post([&](Device&) { ran = true; }), DeviceLost);
  queue.tell_lost("another");
  EXPECT_EQ(queue.lost(), "a fault");
  EXPECT_EQ(told, 1);
  EXPECT_FALSE(ran);
}

TEST(DeviceQueue, MeasuresTheWait) {
  test::FakeDevice device;
  DeviceQueue queue(device);
  Blocker blocker(queue);
  double queue_ms = 0;
  auto waiting = std::async(std::launch::async, [&] { queue.run([](Device&) {}, &queue_ms); });
  wait_for_depth(queue, 1);
  std::this_thread::sleep_for(20ms);
  blocker.release();
  waiting.get();
  EXPECT_GE(queue_ms, 20.0);
}

TEST(DeviceQueue, RefusesMoreThanItsCapacity) {
  test::FakeDevice device;
  DeviceQueue queue(device, {.capacity = 2, .held_wait = 1s});
  Blocker blocker(queue);
  queue.post([](Device&) {});
  queue.post([](Device&) {});
  try {
    queue.run([](Device&) {});
    FAIL() << "it should have been busy";
  } catch (const DeviceBusy& busy) {
    EXPECT_EQ(busy.code(), "busy");
  }
  blocker.release();
}

TEST(DeviceQueue, AHolderIsAlone) {
  test::FakeDevice device;
  DeviceQueue queue(device, {.capacity = 8, .held_wait = 30ms});
  {
    DeviceQueue::Hold hold = queue.hold();
    try {
      queue.run([](Device&) {});
      FAIL() << "the device is held";
    } catch (const DeviceBusy& busy) {
      EXPECT_EQ(busy.code(), "device_busy");
    }
    EXPECT_EQ(hold.run([](Device&) { return 1; }), 1);
    EXPECT_EQ(queue.depth(), 0u);
  }
  EXPECT_EQ(queue.run([](Device&) { return 2; }), 2);
}

TEST(DeviceQueue, WorkThatWaitsForAHoldRunsAfterIt) {
  test::FakeDevice device;
  DeviceQueue queue(device);
  std::atomic<bool> ran = false;
  std::future<void> waiting;
  {
    DeviceQueue::Hold hold = queue.hold();
    waiting = std::async(std::launch::async, [&] { queue.run([&](Device&) { ran = true; }); });
    wait_for_depth(queue, 1);
    hold.run([](Device&) {});
    EXPECT_FALSE(ran);
  }
  waiting.get();
  EXPECT_TRUE(ran);
}

TEST(DeviceQueue, ASecondHoldWaitsForTheFirst) {
  test::FakeDevice device;
  DeviceQueue queue(device);
  std::atomic<bool> second = false;
  std::future<void> waiting;
  {
    DeviceQueue::Hold hold = queue.hold();
    waiting = std::async(std::launch::async, [&] {
      DeviceQueue::Hold other = queue.hold();
      second = true;
    });
    std::this_thread::sleep_for(20ms);
    EXPECT_FALSE(second);
  }
  waiting.get();
  EXPECT_TRUE(second);
}

TEST(DeviceQueue, ManyCallersGetTheirOwnAnswers) {
  test::FakeDevice device;
  DeviceQueue queue(device);
  std::vector<std::future<int>> answers;
  for (int i = 0; i < 32; ++i) {
    answers.push_back(std::async(std::launch::async, [&queue, i] { return queue.run([i](Device&) { return i; }); }));
  }
  for (int i = 0; i < 32; ++i) EXPECT_EQ(answers[static_cast<std::size_t>(i)].get(), i);
}

}  // namespace
}  // namespace raywalk
