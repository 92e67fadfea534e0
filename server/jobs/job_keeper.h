// What keeps jobs and their results beyond the life of the daemon; the queue does not know how.
#pragma once
#include <string>

#include "server/jobs/job.h"

namespace raywalk {

/// Calls come from several threads. What is kept when a call returns is there after a crash.
class JobKeeper {
 public:
  virtual ~JobKeeper() = default;
  /// Inserts or replaces by id. Throws an exception for the job's client when it cannot be kept.
  virtual void keep(const Job& job) = 0;
  /// The same, with its result: both or neither.
  virtual void keep(const Job& job, const JobResult& result) = 0;
  /// And its result. Throws as `keep`.
  virtual void forget(const std::string& id) = 0;
};

}  // namespace raywalk
