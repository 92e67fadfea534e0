// Host threads that make rays and judge answers beside the device.
#pragma once
#include <exception>
#include <thread>
#include <vector>

#include "kernels/platform.h"

namespace raywalk::at_scale {

/// `work(worker)` on a thread each, 0 to `count` - 1; the values by worker. Rethrows what the first one of them threw,
/// when all have ended.
template <class Work>
auto run_workers(u32 count, Work work) {
  std::vector<std::invoke_result_t<Work, u32>> results(count);
  std::vector<std::exception_ptr> errors(count);
  {
    std::vector<std::jthread> threads;
    for (u32 worker = 0; worker < count; ++worker) {
      threads.emplace_back([&, worker] {
        try {
          results[worker] = work(worker);
        } catch (...) {
          errors[worker] = std::current_exception();
        }
      });
    }
  }
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
  return results;
}

}  // namespace raywalk::at_scale
