// Two pieces of page-locked memory that take turns.
#include "server/device/cuda/readback.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

namespace raywalk::cuda {
namespace {

constexpr u64 kPieceBytes = 2u << 20;
constexpr u64 kShareBytes = 256u << 10;  // of a thread: one alone copies slower than the bus brings

void copy_in_shares(const u8* from, u8* to, u64 size_bytes) {
  tbb::parallel_for(tbb::blocked_range<u64>(0, size_bytes, kShareBytes), [&](const tbb::blocked_range<u64>& share) {
    std::memcpy(to + share.begin(), from + share.begin(), share.size());
  });
}

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
    copy_in_shares(place_of(i), static_cast<u8*>(to) + i * kPieceBytes, bytes_of(i));
  }
}

}  // namespace raywalk::cuda
