// From what a job is asked for to what comes out, whatever its kind.
#pragma once
#include "server/jobs/job.h"

namespace raywalk {

/// `report` is called as the work goes on; what it throws ends the job.
JobResult run_job(const JobSpec& spec, const Workplace& place,
                  const std::function<void(const BenchmarkProgress&)>& report);

}  // namespace raywalk
