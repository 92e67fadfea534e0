// The driver's calls for streams, events, modules and launches.
#include "server/device/cuda/launch.h"

namespace raywalk::cuda {

Stream::Stream(const std::shared_ptr<const Context>& context) {
  CUstream stream = nullptr;
  RW_CUDA(context->driver(), cuStreamCreate, &stream, CU_STREAM_NON_BLOCKING);
  handle_ = {context, stream};
}

void Stream::synchronize() const {
  RW_CUDA(driver(), cuStreamSynchronize, get());
}

Event::Event(const std::shared_ptr<const Context>& context) {
  CUevent event = nullptr;
  RW_CUDA(context->driver(), cuEventCreate, &event, CU_EVENT_DEFAULT);
  handle_ = {context, event};
}

void Event::record(const Stream& stream) const {
  RW_CUDA(stream.driver(), cuEventRecord, get(), stream.get());
}

void Event::synchronize() const {
  RW_CUDA(driver(), cuEventSynchronize, get());
}

double Timer::ms() const {
  stop_.synchronize();
  float elapsed_ms = 0;
  RW_CUDA(stop_.driver(), cuEventElapsedTime, &elapsed_ms, start_.get(), stop_.get());
  return elapsed_ms;
}

Module::Module(const std::shared_ptr<const Context>& context, const void* image) {
  CUmodule module = nullptr;
  RW_CUDA(context->driver(), cuModuleLoadData, &module, image);
  handle_ = {context, module};
}

CUfunction Module::function(const char* name) const {
  CUfunction function = nullptr;
  RW_CUDA(handle_.context().driver(), cuModuleGetFunction, &function, handle_.get(), name);
  return function;
}

void Launcher::launch(CUfunction kernel, const Grid& grid, void** arguments) {
  const DriverApi& driver = stream_.driver();
  if (++launches_ == fault_after_) {
    RW_CUDA(driver, cuLaunchKernel, fault_, 1, 1, 1, 1, 1, 1, 0, stream_.get(), nullptr, nullptr);
    return;
  }
  RW_CUDA(driver, cuLaunchKernel, kernel, grid.x, grid.y, 1, grid.block, 1, 1, 0, stream_.get(), arguments, nullptr);
}

}  // namespace raywalk::cuda
