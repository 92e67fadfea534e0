// Calls of SQLite, each checked.
#include "server/store/database.h"

#include <sqlite3.h>

namespace raywalk::store {
namespace {

[[noreturn]] void fail(sqlite3* database, int code) {
  const int primary = code & 0xff;
  const bool damaged = primary == SQLITE_CORRUPT || primary == SQLITE_NOTADB;
  throw DatabaseError(database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code), damaged);
}

}  // namespace

Statement::Statement(sqlite3* database, std::string_view sql) : database_(database) {
  check(sqlite3_prepare_v2(database_, sql.data(), static_cast<int>(sql.size()), &statement_, nullptr));
}

Statement::~Statement() {
  sqlite3_finalize(statement_);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) fail(database_, code);
}

Statement& Statement::text(std::string_view value) {
  check(sqlite3_bind_text64(statement_, ++bound_, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}

Statement& Statement::bytes(std::string_view value) {
  // Of length 0 and without an address it would be NULL.
  check(sqlite3_bind_blob64(statement_, ++bound_, value.empty() ? "" : value.data(), value.size(), SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::integer(u64 value) {
  check(sqlite3_bind_int64(statement_, ++bound_, static_cast<sqlite3_int64>(value)));
  return *this;
}

Statement& Statement::number(double value) {
  check(sqlite3_bind_double(statement_, ++bound_, value));
  return *this;
}

Statement& Statement::null() {
  check(sqlite3_bind_null(statement_, ++bound_));
  return *this;
}

Statement& Statement::bytes_or_null(const std::optional<std::string>& value) {
  return value ? bytes(*value) : null();
}

Statement& Statement::integer_or_null(const std::optional<u64>& value) {
  return value ? integer(*value) : null();
}

bool Statement::next() {
  column_ = 0;
  const int code = sqlite3_step(statement_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) fail(database_, code);
  return code == SQLITE_ROW;
}

void Statement::run() {
  while (next()) {
  }
}

std::string Statement::read_text() {
  const void* value = sqlite3_column_blob(statement_, column_);
  const int size = sqlite3_column_bytes(statement_, column_++);
  return value != nullptr ? std::string(static_cast<const char*>(value), static_cast<std::size_t>(size)) : "";
}

u64 Statement::read_integer() {
  return static_cast<u64>(sqlite3_column_int64(statement_, column_++));
}

double Statement::read_number() {
  return sqlite3_column_double(statement_, column_++);
}

bool Statement::is_null() const {
  return sqlite3_column_type(statement_, column_) == SQLITE_NULL;
}

std::optional<std::string> Statement::read_text_or_null() {
  if (!is_null()) return read_text();
  ++column_;
  return std::nullopt;
}

std::optional<u64> Statement::read_integer_or_null() {
  if (!is_null()) return read_integer();
  ++column_;
  return std::nullopt;
}

Database::Database(const std::filesystem::path& file) {
  const int code = sqlite3_open_v2(file.c_str(), &database_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  try {
    if (code != SQLITE_OK) fail(database_, code);
    // Held by one process, the log needs no shared memory, which network file systems do not have.
    run("PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;"
        "PRAGMA foreign_keys = ON;");
  } catch (...) {
    sqlite3_close(database_);
    throw;
  }
}

Database::~Database() {
  sqlite3_close(database_);
}

void Database::run(const char* sql) {
  const int code = sqlite3_exec(database_, sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(database_, code);
}

Transaction::~Transaction() {
  if (committed_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const DatabaseError&) {  // a failed statement may have ended it already
  }
}

void Transaction::commit() {
  database_.run("COMMIT");
  committed_ = true;
}

}  // namespace raywalk::store
