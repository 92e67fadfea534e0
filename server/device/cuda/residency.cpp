// Allocation within the budget, least recently used copies first to go.
#include "server/device/cuda/residency.h"

#include <algorithm>

#include "server/device/device.h"

namespace raywalk::cuda {

std::shared_ptr<Residency::Copy> Residency::copy_of(const std::shared_ptr<const Blob>& blob) {
  const std::scoped_lock lock(mutex_);
  for (Copy* copy : copies_) {
    if (&copy->blob() != blob.get()) continue;
    if (auto shared = copy->weak_from_this().lock()) return shared;  // else it ends just now
  }
  auto copy = std::make_shared<Copy>(shared_from_this(), blob);
  copies_.push_back(copy.get());
  return copy;
}

Residency::Held Residency::hold(const std::shared_ptr<Copy>& copy) {
  const std::scoped_lock lock(mutex_);
  if (!copy->memory_) {
    const Blob& blob = copy->blob();
    DeviceBuffer memory = allocate(std::max<u64>(blob.size_bytes(), 1));  // brute's blob is empty
    if (blob.size_bytes() > 0) {
      RW_CUDA(context_->driver(), cuMemcpyHtoDAsync, memory.address(), blob.data(), blob.size_bytes(), stream_->get());
      stream_->synchronize();
    }
    copy->memory_ = std::move(memory);
  }
  copy->last_use_ = ++uses_;
  ++copy->holds_;
  return {copy, copy->memory_.address()};
}

Residency::Scratch Residency::scratch(u64 size_bytes) {
  const std::scoped_lock lock(mutex_);
  const auto smaller = [](const DeviceBuffer& a, const DeviceBuffer& b) { return a.size_bytes() < b.size_bytes(); };
  std::sort(spares_.begin(), spares_.end(), smaller);
  const auto fits = std::find_if(spares_.begin(), spares_.end(),
                                 [&](const DeviceBuffer& spare) { return spare.size_bytes() >= size_bytes; });
  if (fits != spares_.end()) {
    DeviceBuffer memory = std::move(*fits);
    spares_.erase(fits);
    return {*this, std::move(memory)};
  }
  // The largest spare makes way for a larger one: there are never more spares than were once in use together.
  if (!spares_.empty()) spares_.pop_back();
  return {*this, allocate(size_bytes)};
}

bool Residency::drop_all() {
  const std::scoped_lock lock(mutex_);
  bool any = false;
  while (drop_something()) any = true;
  return any;
}

u64 Residency::resident_bytes() const {
  const std::scoped_lock lock(mutex_);
  u64 sum = 0;
  for (const Copy* copy : copies_) sum += copy->memory_.size_bytes();
  return sum;
}

u64 Residency::free_bytes() const {
  const u64 of_card = context_->memory().free_bytes;
  if (limit_bytes_ == 0) return of_card;
  const u64 allocated = allocated_bytes_;
  return std::min(of_card, limit_bytes_ - std::min(limit_bytes_, allocated));
}

/// The mutex is held by the caller.
DeviceBuffer Residency::allocate(u64 size_bytes) {
  const u64 at_most = limit_bytes_ == 0 ? context_->facts().memory_bytes : limit_bytes_;
  const auto try_once = [&]() -> DeviceBuffer {
    if (limit_bytes_ != 0 && allocated_bytes_ + size_bytes > limit_bytes_) return {};
    return DeviceBuffer::try_allocate(context_, size_bytes, allocated_bytes_);
  };
  if (size_bytes <= at_most) {
    do {
      if (DeviceBuffer memory = try_once()) return memory;
    } while (drop_something());
  }
  // What could make way counts as free, and what is held for the same request as needed.
  throw OutOfDeviceMemory(in_use_bytes() + size_bytes, allocated_bytes_ + free_bytes());
}

/// The mutex is held by the caller.
u64 Residency::in_use_bytes() const {
  u64 bytes = allocated_bytes_;
  for (const std::vector<DeviceBuffer>* unused : {&spares_, &abandoned_})
    for (const DeviceBuffer& buffer : *unused) bytes -= buffer.size_bytes();
  for (const Copy* copy : copies_)
    if (copy->holds_ == 0) bytes -= copy->memory_.size_bytes();
  return bytes;
}

/// The mutex is held by the caller. Cheapest to lose first.
bool Residency::drop_something() {
  if (!abandoned_.empty() || !spares_.empty()) {
    abandoned_.clear();
    spares_.clear();
    return true;
  }
  Copy* oldest = nullptr;
  for (Copy* copy : copies_) {
    if (!copy->memory_ || copy->holds_ > 0) continue;
    if (oldest == nullptr || copy->last_use_ < oldest->last_use_) oldest = copy;
  }
  if (oldest == nullptr) return false;
  oldest->memory_.reset();
  return true;
}

void Residency::forget(Copy& copy) {
  const std::scoped_lock lock(mutex_);
  std::erase(copies_, &copy);
  if (!copy.memory_) return;
  if (working_) {
    abandoned_.push_back(std::move(copy.memory_));
  } else {
    copy.memory_.reset();
  }
}

Residency::Held::~Held() {
  if (!copy_) return;  // moved from
  const std::scoped_lock lock(copy_->home_->mutex_);
  --copy_->holds_;
}

Residency::Scratch::~Scratch() {
  if (!memory_) return;  // moved from
  const std::scoped_lock lock(home_->mutex_);
  home_->spares_.push_back(std::move(memory_));
}

Residency::Working::Working(Residency& residency) : residency_(residency) {
  const std::scoped_lock lock(residency_.mutex_);
  residency_.working_ = true;
}

Residency::Working::~Working() {
  const std::scoped_lock lock(residency_.mutex_);
  residency_.working_ = false;
  residency_.abandoned_.clear();
}

}  // namespace raywalk::cuda
