// Device copies of host blobs: uploaded once, counted, dropped when room is needed, uploaded again at their next use.
// Working memory comes from the same budget.
#pragma once
#include <mutex>
#include <vector>

#include "kernels/blob_writer.h"
#include "server/device/cuda/launch.h"
#include "server/device/cuda/memory.h"

namespace raywalk::cuda {

/// One thread uses it at a time; copies may end, and figures be asked for, on any thread.
class Residency : public std::enable_shared_from_this<Residency> {
 public:
  class Copy;
  class Held;
  class Scratch;
  class Working;

  /// `limit_bytes` of all allocations together; 0: as much as the device has.
  Residency(std::shared_ptr<const Context> context, std::shared_ptr<const Stream> stream, u64 limit_bytes)
      : context_(std::move(context)), stream_(std::move(stream)), limit_bytes_(limit_bytes) {}

  /// The copy of this very blob, which everybody shares who asks for it; it lies on the device from its first `hold`
  /// on. Ends with its last pointer, and keeps the blob until then.
  std::shared_ptr<Copy> copy_of(const std::shared_ptr<const Blob>& blob);
  /// Uploads unless it lies there. Throws OutOfDeviceMemory, which tells what is needed together with all that is in
  /// use now, and CudaError.
  Held hold(const std::shared_ptr<Copy>& copy);
  /// Working memory, uninitialised, of `size_bytes` (over 0) or more. Throws as `hold` does. What a
  /// launch reads is held before: else this may drop it.
  Scratch scratch(u64 size_bytes);
  /// Drops everything that nobody holds; false when there was nothing.
  bool drop_all();

  u64 allocated_bytes() const { return allocated_bytes_; }
  /// Of the copies that lie on the device.
  u64 resident_bytes() const;
  /// What could be allocated now with nothing dropped. Throws CudaError.
  u64 free_bytes() const;

 private:
  DeviceBuffer allocate(u64 size_bytes);
  u64 in_use_bytes() const;
  bool drop_something();
  void forget(Copy& copy);

  std::shared_ptr<const Context> context_;
  std::shared_ptr<const Stream> stream_;
  const u64 limit_bytes_;
  std::atomic<u64> allocated_bytes_{0};
  mutable std::mutex mutex_;  // of all below
  std::vector<Copy*> copies_;
  std::vector<DeviceBuffer> spares_;     // working memory that nobody uses now
  std::vector<DeviceBuffer> abandoned_;  // of copies that ended while the device worked
  u64 uses_ = 0;
  bool working_ = false;
};

class Residency::Copy : public std::enable_shared_from_this<Copy> {
 public:
  Copy(std::shared_ptr<Residency> home, std::shared_ptr<const Blob> blob)
      : home_(std::move(home)), blob_(std::move(blob)) {}
  ~Copy() { home_->forget(*this); }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  const Blob& blob() const { return *blob_; }

 private:
  friend class Residency;
  std::shared_ptr<Residency> home_;
  std::shared_ptr<const Blob> blob_;
  DeviceBuffer memory_;
  u64 last_use_ = 0;
  u32 holds_ = 0;
};

/// While it lives, the copy stays where it is.
class Residency::Held {
 public:
  Held(Held&&) = default;
  ~Held();
  CUdeviceptr address() const { return address_; }

 private:
  friend class Residency;
  Held(std::shared_ptr<Copy> copy, CUdeviceptr address) : copy_(std::move(copy)), address_(address) {}
  std::shared_ptr<Copy> copy_;
  CUdeviceptr address_;
};

/// Goes back for the next use. The residency outlives it.
class Residency::Scratch {
 public:
  Scratch(Scratch&&) = default;
  ~Scratch();
  CUdeviceptr address() const { return memory_.address(); }

 private:
  friend class Residency;
  Scratch(Residency& home, DeviceBuffer memory) : home_(&home), memory_(std::move(memory)) {}
  Residency* home_;
  DeviceBuffer memory_;
};

/// While it lives, copies that end on other threads are freed by nobody, so that they do not disturb what is measured;
/// they are freed with its end.
class Residency::Working {
 public:
  explicit Working(Residency& residency);
  ~Working();
  Working(const Working&) = delete;
  Working& operator=(const Working&) = delete;

 private:
  Residency& residency_;
};

}  // namespace raywalk::cuda
