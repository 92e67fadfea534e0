// The measuring loop of the benchmarks, with lists of rays for frames.
#include "server/accuracy/sweep/measuring.h"

namespace raywalk::accuracy {
namespace {

class ListTechnique : public raywalk::Technique {
 public:
  ListTechnique(DeviceQueue::Hold& hold, const TimedList& list)
      : hold_(hold), job_(list.combination->job(list.rays)), query_(list.query) {}
  double measure(u32, u32) override {
    return hold_.run([&](Device& device) { return device.measure_rays(job_, query_, 1).front(); });
  }

 private:
  DeviceQueue::Hold& hold_;
  RayJob job_;
  RayQuery query_;
};

}  // namespace

Measurements measure_lists(std::span<const TimedList> lists, u32 launches, double time_limit_s, DeviceQueue& queue,
                           const std::function<void(double fraction)>& report) {
  DeviceQueue::Hold hold = queue.hold();
  std::vector<ListTechnique> techniques;
  techniques.reserve(lists.size());
  std::vector<raywalk::Technique*> pointers;
  for (const TimedList& list : lists) pointers.push_back(&techniques.emplace_back(hold, list));
  const MeasurePlan plan{.warmup = 1, .repeats = launches, .time_limit_s = time_limit_s};
  return measure(pointers, plan,
                 [&](u64 done, u64 total) { report(static_cast<double>(done) / static_cast<double>(total)); });
}

}  // namespace raywalk::accuracy
