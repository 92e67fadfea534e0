// Host only: owns the bytes of a blob and lays slices out in it, 64-byte aligned.
#pragma once
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "kernels/blob.h"

namespace raywalk {

constexpr u64 kBlobAlignment = 64;

/// Bytes that may be copied anywhere (another address, a GPU, a file) and still be read through their header.
class Blob {
 public:
  Blob() = default;
  /// Uninitialised storage of `size_bytes`. Throws std::bad_alloc.
  explicit Blob(u64 size_bytes)
      : bytes_(static_cast<u8*>(::operator new (size_bytes, std::align_val_t{kBlobAlignment}))),
        size_bytes_(size_bytes) {}

  u8* data() { return bytes_.get(); }
  const u8* data() const { return bytes_.get(); }
  u64 size_bytes() const { return size_bytes_; }
  template <class Header>
  const Header& header() const {
    return header_of<Header>(data());
  }

 private:
  struct Release {
    void operator()(u8* p) const { ::operator delete (p, std::align_val_t{kBlobAlignment}); }
  };
  std::unique_ptr<u8[], Release> bytes_;
  u64 size_bytes_ = 0;
};

/// Reserve every slice first, allocate once, then fill: the blob never holds its contents twice.
///   BlobPlan plan(sizeof(Header)); auto nodes = plan.add<Node>(n); Blob blob = plan.allocate();
///   std::span<Node> out = slice_of(blob, nodes);
class BlobPlan {
 public:
  explicit BlobPlan(u64 header_bytes) : size_bytes_(aligned(header_bytes)) {}

  template <class T>
  Slice<T> add(u64 count) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= kBlobAlignment);
    const Slice<T> slice{size_bytes_, count};
    size_bytes_ = aligned(size_bytes_ + count * sizeof(T));
    return slice;
  }
  Blob allocate() const { return Blob(size_bytes_); }

 private:
  static u64 aligned(u64 n) { return (n + kBlobAlignment - 1) / kBlobAlignment * kBlobAlignment; }
  u64 size_bytes_;
};

template <class T>
std::span<T> slice_of(Blob& blob, Slice<T> slice) {
  return {reinterpret_cast<T*>(blob.data() + slice.offset), static_cast<size_t>(slice.count)};
}
template <class T>
std::span<const T> slice_of(const Blob& blob, Slice<T> slice) {
  return {reinterpret_cast<const T*>(blob.data() + slice.offset), static_cast<size_t>(slice.count)};
}

}  // namespace raywalk
