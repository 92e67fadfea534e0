// Storage of frames, used again: a fresh one costs more page faults than its pixels cost to encode.
#pragma once
#include <memory>
#include <mutex>
#include <vector>

#include "server/device/device.h"

namespace raywalk::api {

class FramePool {
 public:
  /// A frame that goes back to the pool with its owner.
  class Lease {
   public:
    Lease(FramePool& pool, Frame frame) : pool_(pool), frame_(std::move(frame)) {}
    ~Lease() { pool_.take_back(std::move(frame_)); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    Frame& frame() { return frame_; }

   private:
    FramePool& pool_;
    Frame frame_;
  };

  Lease lease() {
    const std::lock_guard lock(mutex_);
    if (frames_.empty()) return {*this, Frame{}};
    Frame frame = std::move(frames_.back());
    frames_.pop_back();
    return {*this, std::move(frame)};
  }

 private:
  static constexpr std::size_t kMostFrames = 8;
  static constexpr std::size_t kMostValues = std::size_t{3} * 2048 * 2048;  // larger ones are not kept

  void take_back(Frame frame) {
    const std::lock_guard lock(mutex_);
    if (frames_.size() < kMostFrames && frame.pixels.capacity() <= kMostValues) frames_.push_back(std::move(frame));
  }

  std::mutex mutex_;
  std::vector<Frame> frames_;
};

}  // namespace raywalk::api
