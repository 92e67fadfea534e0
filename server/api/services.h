// What handlers work with; made once by main.
#pragma once
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "server/api/frame_pool.h"
#include "server/api/metrics.h"
#include "server/catalog/pins.h"
#include "server/catalog/scenes.h"
#include "server/catalog/structures.h"
#include "server/device/device_queue.h"
#include "server/http/contract.h"
#include "server/http/server.h"
#include "server/jobs/job_queue.h"
#include "server/store/store.h"

namespace raywalk::api {

struct Services {
  const http::Contract& contract;
  http::Limits limits;
  Machine machine;
  std::string requested_device;  // the flag of the daemon
  std::string no_cuda;           // why no GPU is used; empty: one is, or none was asked for
  std::vector<std::string> warnings;
  DeviceQueue& queue;
  Scenes& scenes;
  Structures& structures;
  JobQueue& jobs;
  store::Store& store;
  Metrics& metrics;
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
  FramePool frames = {};
  Pins pins = {};
  std::mutex large_frame = {};  // one frame of many pixels is in memory at a time
};

constexpr u32 kMaxSidePixels = 8192;
constexpr u32 kMaxDepth = 16;
constexpr u32 kMaxFrames = 100'000;
constexpr u32 kMaxTriangles = 100'000'000;

/// The route table: a handler for every operation of the contract.
std::vector<http::Route> routes(Services& services);

}  // namespace raywalk::api
