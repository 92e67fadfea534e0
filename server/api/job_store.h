// Jobs and results as texts in the store, and what becomes of them when a daemon starts.
#pragma once
#include <vector>

#include "server/jobs/job_keeper.h"
#include "server/store/store.h"

namespace raywalk::api {

/// Its calls throw Refusal storage_failed when the store cannot do what it should.
class JobStore : public JobKeeper {
 public:
  /// Both outlive it.
  JobStore(store::Store& store, const std::vector<KindInfo>& kinds) : store_(store), kinds_(kinds) {}

  /// The jobs that the daemon before left, oldest first. The one that ran failed with it (daemon_crashed), or is
  /// interrupted if the daemon was told to stop; nothing runs a second time by itself, for it may be what crashed the
  /// daemon. Those that waited wait again.
  std::vector<Job> recover();

  void keep(const Job& job) override;
  void keep(const Job& job, const JobResult& result) override;
  void forget(const std::string& id) override;

 private:
  store::Store& store_;
  const std::vector<KindInfo>& kinds_;
};

}  // namespace raywalk::api
