// One line a kind.
#include "server/jobs/run_job.h"

namespace raywalk {

JobResult run_job(const JobSpec& spec, const Workplace& place,
                  const std::function<void(const BenchmarkProgress&)>& report) {
  if (const auto* benchmark = std::get_if<BenchmarkSpec>(&spec)) return run_benchmark(*benchmark, place, report);
  return accuracy::run_accuracy(std::get<accuracy::AccuracySpec>(spec), place, report);
}

}  // namespace raywalk
