// What outlives the daemon: jobs, results, what was resident, and whether it ended in good order. It keeps bytes and
// knows nothing of what is in them.
#pragma once
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "server/store/database.h"

namespace raywalk::store {

/// `spec`, `error` and `options` are the texts that the caller makes of them.
struct JobRow {
  std::string id, kind, spec, state, stage;
  std::string key;  // Idempotency-Key; empty: none
  u32 attempt = 1;
  u64 version = 1;
  double progress = 0;
  u64 frames_done = 0, frames_total = 0;
  std::optional<std::string> error;
  std::string created_at, started_at, ended_at;  // RFC 3339; empty: not yet
  bool has_result = false;                       // as read; saving a result sets it
};

struct ResultRow {
  std::string json, csv;
};

struct ResidentScene {
  std::string name;
  std::optional<u64> triangles;  // as asked for
};

struct ResidentStructure {
  std::string id, scene, kind, options;
};

struct Resident {
  std::vector<ResidentScene> scenes;
  std::vector<ResidentStructure> structures;
};

/// From any thread. Every call may throw DatabaseError; what it did not finish is as before.
class Store {
 public:
  /// Opens `folder`/raywalk.db. A file that is damaged or of another version is moved aside with a warning in the log,
  /// and a new one begun.
  explicit Store(const std::filesystem::path& folder);

  /// The session before was not ended.
  bool crashed_before() const { return crashed_before_; }
  /// The kind of device that the crashed session had; empty when it did not crash.
  const std::string& crashed_device() const { return crashed_device_; }
  /// From now on the daemon serves, with a device of this kind.
  void begin_session(const std::string& device);
  /// The daemon stops because it was told to. Throws nothing: a failure is logged.
  void end_session();

  /// Inserts or replaces by id; the order of first saving is kept.
  void save(const JobRow& job);
  /// Both or neither.
  void save(const JobRow& job, const ResultRow& result);
  /// And its result.
  void forget_job(const std::string& id);
  /// Oldest first.
  std::vector<JobRow> jobs();
  std::optional<ResultRow> result(const std::string& job_id);

  /// Drops the structures of what was resident under the name before.
  void add_scene(const ResidentScene& scene);
  /// And its structures.
  void drop_scene(const std::string& name);
  /// Ignored unless its scene is there.
  void add_structure(const ResidentStructure& structure);
  void drop_structure(const std::string& id);
  Resident resident();
  /// Nothing is resident any more.
  void forget_resident();

 private:
  void save_now(const JobRow& job);

  std::mutex mutex_;
  std::optional<Database> database_;
  bool crashed_before_ = false;
  std::string crashed_device_;
};

}  // namespace raywalk::store
