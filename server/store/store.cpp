// The schema and its statements.
#include "server/store/store.h"

#include <spdlog/spdlog.h>

#include "server/system/time_text.h"

namespace raywalk::store {
namespace {

constexpr u64 kVersion = 1;  // of the schema

constexpr const char* kSchema = R"(
  CREATE TABLE session (ended INTEGER NOT NULL, device TEXT NOT NULL);
  CREATE TABLE jobs (
    number INTEGER PRIMARY KEY AUTOINCREMENT, id TEXT NOT NULL UNIQUE, kind TEXT NOT NULL, spec BLOB NOT NULL,
    state TEXT NOT NULL, stage TEXT NOT NULL, key BLOB NOT NULL, attempt INTEGER NOT NULL, version INTEGER NOT NULL,
    progress REAL NOT NULL, frames_done INTEGER NOT NULL, frames_total INTEGER NOT NULL, error BLOB,
    created_at TEXT NOT NULL, started_at TEXT NOT NULL, ended_at TEXT NOT NULL);
  CREATE TABLE results (
    job TEXT PRIMARY KEY REFERENCES jobs (id) ON DELETE CASCADE, json BLOB NOT NULL, csv BLOB NOT NULL);
  CREATE TABLE resident_scenes (name TEXT PRIMARY KEY, triangles INTEGER);
  CREATE TABLE resident_structures (
    id TEXT PRIMARY KEY, scene TEXT NOT NULL REFERENCES resident_scenes (name) ON DELETE CASCADE, kind TEXT NOT NULL,
    options BLOB NOT NULL);
  INSERT INTO session VALUES (1, '');
)";

u64 number_of(Database& database, const char* sql) {
  Statement statement = database.statement(sql);
  return statement.next() ? statement.read_integer() : 0;
}

void check_sound(Database& database) {
  Statement check = database.statement("PRAGMA quick_check(1)");
  if (!check.next()) return;
  if (const std::string found = check.read_text(); found != "ok") throw DatabaseError(found, /*damaged=*/true);
}

/// A sound database of this version; the schema is made in an empty one.
void open_sound(std::optional<Database>& database, const std::filesystem::path& file) {
  database.emplace(file);
  check_sound(*database);
  const u64 version = number_of(*database, "PRAGMA user_version");
  if (version == kVersion) return;
  if (version != 0 || number_of(*database, "SELECT count(*) FROM sqlite_schema") != 0) {
    throw DatabaseError("its version is " + std::to_string(version) + ", this daemon's " + std::to_string(kVersion),
                        /*damaged=*/true);
  }
  Transaction transaction(*database);
  database->run(kSchema);
  database->run(("PRAGMA user_version = " + std::to_string(kVersion)).c_str());
  transaction.commit();
}

/// With the write-ahead log that belongs to it.
std::filesystem::path move_aside(const std::filesystem::path& file) {
  std::filesystem::path aside = file;
  aside += ".aside-" + now_text();
  std::filesystem::rename(file, aside);
  for (const char* ending : {"-wal", "-shm"}) {
    std::error_code none;  // it may not exist
    std::filesystem::rename(file.string() + ending, aside.string() + ending, none);
  }
  return aside;
}

}  // namespace

Store::Store(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "raywalk.db";
  try {
    open_sound(database_, file);
  } catch (const DatabaseError& e) {
    if (!e.damaged()) throw;
    database_.reset();
    const std::filesystem::path aside = move_aside(file);
    spdlog::warn("the database of jobs and results cannot be used ({}); it lies at {} now and a new one begins",
                 e.what(), aside.string());
    open_sound(database_, file);
  }
  crashed_before_ = number_of(*database_, "SELECT ended FROM session") == 0;
  Statement device = database_->statement("SELECT device FROM session");
  if (crashed_before_ && device.next()) crashed_device_ = device.read_text();
}

void Store::begin_session(const std::string& device) {
  const std::lock_guard lock(mutex_);
  database_->statement("UPDATE session SET ended = 0, device = ?").text(device).run();
}

void Store::end_session() {
  const std::lock_guard lock(mutex_);
  try {
    database_->run("UPDATE session SET ended = 1");
  } catch (const DatabaseError& e) {
    spdlog::error("this stop will look like a crash: {}", e.what());
  }
}

void Store::save_now(const JobRow& job) {
  Statement save = database_->statement(
      "INSERT INTO jobs (id, kind, spec, state, stage, key, attempt, version, progress, frames_done, frames_total, "
      "error, created_at, started_at, ended_at) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
      "ON CONFLICT (id) DO UPDATE SET kind = excluded.kind, spec = excluded.spec, state = excluded.state, "
      "stage = excluded.stage, key = excluded.key, attempt = excluded.attempt, version = excluded.version, "
      "progress = excluded.progress, frames_done = excluded.frames_done, frames_total = excluded.frames_total, "
      "error = excluded.error, created_at = excluded.created_at, started_at = excluded.started_at, "
      "ended_at = excluded.ended_at");
  save.text(job.id).text(job.kind).bytes(job.spec).text(job.state).text(job.stage).bytes(job.key);
  save.integer(job.attempt).integer(job.version).number(job.progress);
  save.integer(job.frames_done).integer(job.frames_total).bytes_or_null(job.error);
  save.text(job.created_at).text(job.started_at).text(job.ended_at).run();
}

void Store::save(const JobRow& job) {
  const std::lock_guard lock(mutex_);
  save_now(job);
}

void Store::save(const JobRow& job, const ResultRow& result) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(*database_);
  save_now(job);
  database_->statement("INSERT OR REPLACE INTO results (job, json, csv) VALUES (?, ?, ?)")
      .text(job.id)
      .bytes(result.json)
      .bytes(result.csv)
      .run();
  transaction.commit();
}

void Store::forget_job(const std::string& id) {
  const std::lock_guard lock(mutex_);
  database_->statement("DELETE FROM jobs WHERE id = ?").text(id).run();
}

std::vector<JobRow> Store::jobs() {
  const std::lock_guard lock(mutex_);
  Statement rows = database_->statement(
      "SELECT id, kind, spec, state, stage, key, attempt, version, progress, frames_done, frames_total, error, "
      "created_at, started_at, ended_at, results.job IS NOT NULL "
      "FROM jobs LEFT JOIN results ON results.job = jobs.id ORDER BY number");
  std::vector<JobRow> jobs;
  while (rows.next()) {
    JobRow& job = jobs.emplace_back();
    for (std::string* text : {&job.id, &job.kind, &job.spec, &job.state, &job.stage, &job.key}) {
      *text = rows.read_text();
    }
    job.attempt = static_cast<u32>(rows.read_integer());
    job.version = rows.read_integer();
    job.progress = rows.read_number();
    job.frames_done = rows.read_integer();
    job.frames_total = rows.read_integer();
    job.error = rows.read_text_or_null();
    for (std::string* text : {&job.created_at, &job.started_at, &job.ended_at}) *text = rows.read_text();
    job.has_result = rows.read_integer() != 0;
  }
  return jobs;
}

std::optional<ResultRow> Store::result(const std::string& job_id) {
  const std::lock_guard lock(mutex_);
  Statement row = database_->statement("SELECT json, csv FROM results WHERE job = ?");
  row.text(job_id);
  if (!row.next()) return std::nullopt;
  ResultRow result;
  result.json = row.read_text();
  result.csv = row.read_text();
  return result;
}

void Store::add_scene(const ResidentScene& scene) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(*database_);
  database_->statement("DELETE FROM resident_scenes WHERE name = ?").text(scene.name).run();
  database_->statement("INSERT INTO resident_scenes (name, triangles) VALUES (?, ?)")
      .text(scene.name)
      .integer_or_null(scene.triangles)
      .run();
  transaction.commit();
}

void Store::drop_scene(const std::string& name) {
  const std::lock_guard lock(mutex_);
  database_->statement("DELETE FROM resident_scenes WHERE name = ?").text(name).run();
}

void Store::add_structure(const ResidentStructure& structure) {
  const std::lock_guard lock(mutex_);
  database_
      ->statement(
          "INSERT OR REPLACE INTO resident_structures (id, scene, kind, options) SELECT ?1, ?2, ?3, ?4 "
          "WHERE EXISTS (SELECT 1 FROM resident_scenes WHERE name = ?2)")
      .text(structure.id)
      .text(structure.scene)
      .text(structure.kind)
      .bytes(structure.options)
      .run();
}

void Store::drop_structure(const std::string& id) {
  const std::lock_guard lock(mutex_);
  database_->statement("DELETE FROM resident_structures WHERE id = ?").text(id).run();
}

Resident Store::resident() {
  const std::lock_guard lock(mutex_);
  Resident resident;
  {
    Statement rows = database_->statement("SELECT name, triangles FROM resident_scenes ORDER BY rowid");
    while (rows.next()) {
      ResidentScene& scene = resident.scenes.emplace_back();
      scene.name = rows.read_text();
      scene.triangles = rows.read_integer_or_null();
    }
  }
  {
    Statement rows = database_->statement("SELECT id, scene, kind, options FROM resident_structures ORDER BY rowid");
    while (rows.next()) {
      ResidentStructure& structure = resident.structures.emplace_back();
      for (std::string* text : {&structure.id, &structure.scene, &structure.kind, &structure.options}) {
        *text = rows.read_text();
      }
    }
  }
  return resident;
}

void Store::forget_resident() {
  const std::lock_guard lock(mutex_);
  database_->run("DELETE FROM resident_scenes");
}

}  // namespace raywalk::store
