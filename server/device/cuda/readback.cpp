// Two pieces of page-locked memory that take turns.
#include "server/device/cuda/readback.h"

#include <algorithm>
#include <cstring>

namespace raywalk::cuda {
namespace {

constexpr u64 kPieceBytes = 2u << 20;

}  // namespace

Readback::Readback(const std::shared_ptr<const Context>& context, const Stream& stream)
    : stream_(stream), pieces_(context, 2 * kPieceBytes), ready_{Event(context), Event(context)} {}

void Readback::copy(CUdeviceptr from, void* to, u64 size_bytes) const {
  const u64 pieces = (size_bytes + kPieceBytes - 1) / kPieceBytes;
  const auto bytes_of = [&](u64 i) { return std::min(kPieceBytes, size_bytes - i * kPieceBytes); };
  const auto place_of = [&](u64 i) { return pieces_.data() + i % 2 * kPieceBytes; };
  const auto start = [&](u64 i) {
    RW_CUDA(stream_.driver(), cuMemcpyDtoHAsync, place_of(i), from + i * kPieceBytes, bytes_of(i), stream_.get());
    ready_[i % 2].record(stream_);
  };
  if (pieces > 0) start(0);
  for (u64 i = 0; i < pieces; ++i) {
    if (i + 1 < pieces) start(i + 1);
    ready_[i % 2].synchronize();
    std::memcpy(static_cast<u8*>(to) + i * kPieceBytes, place_of(i), bytes_of(i));
  }
}

}  // namespace raywalk::cuda
