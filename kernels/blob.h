// A built structure or scene is one position-independent blob: a header at offset 0 and slices that it names.
#pragma once
#include "kernels/platform.h"

namespace raywalk {

/// `count` elements of T at `offset` bytes from the blob's start.
template <class T>
struct Slice {
  u64 offset;
  u64 count;
};

template <class T>
RW_FN const T* data_of(const u8* blob, Slice<T> slice) {
  return reinterpret_cast<const T*>(blob + slice.offset);
}

template <class Header>
RW_FN const Header& header_of(const u8* blob) {
  return *reinterpret_cast<const Header*>(blob);
}

}  // namespace raywalk
