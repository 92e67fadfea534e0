// Owner of one object of the CUDA driver.
#pragma once
#include <utility>

#include "server/device/cuda/context.h"

namespace raywalk::cuda {

/// `kDestroy` is the driver's call that ends the object. Its errors are ignored: a destructor can mend nothing, and
/// whatever broke the device shows again at the next use.
template <class T, CUresult (*DriverApi::*kDestroy)(T)>
class Handle {
 public:
  Handle() = default;
  Handle(std::shared_ptr<const Context> context, T value) : context_(std::move(context)), value_(value) {}
  ~Handle() { reset(); }
  Handle(Handle&& other) noexcept { swap(other); }
  Handle& operator=(Handle&& other) noexcept {
    Handle(std::move(other)).swap(*this);
    return *this;
  }

  T get() const { return value_; }
  explicit operator bool() const { return context_ != nullptr; }
  const Context& context() const { return *context_; }

  /// On any thread: the context becomes current there.
  void reset() {
    if (!context_) return;
    const DriverApi& driver = context_->driver();
    if (context_->try_make_current()) (driver.*kDestroy)(value_);
    context_.reset();
    value_ = {};
  }

 private:
  void swap(Handle& other) noexcept {
    std::swap(context_, other.context_);
    std::swap(value_, other.value_);
  }
  std::shared_ptr<const Context> context_;
  T value_{};
};

}  // namespace raywalk::cuda
