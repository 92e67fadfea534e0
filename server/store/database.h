// SQLite behind two small types: a database and its statements.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "kernels/platform.h"

struct sqlite3;
struct sqlite3_stmt;

namespace raywalk::store {

/// The database could not do what it was asked for: a full disk, a damaged file.
class DatabaseError : public std::runtime_error {
 public:
  /// `damaged`: the file is not a database, or not a sound one.
  DatabaseError(const std::string& what, bool damaged) : std::runtime_error(what), damaged_(damaged) {}
  bool damaged() const { return damaged_; }

 private:
  bool damaged_;
};

/// One statement: values are bound in their order, and columns read in theirs. Every call may throw DatabaseError.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& text(std::string_view value);
  /// Any bytes; they come back as they are.
  Statement& bytes(std::string_view value);
  Statement& integer(u64 value);
  Statement& number(double value);
  Statement& null();
  Statement& bytes_or_null(const std::optional<std::string>& value);
  Statement& integer_or_null(const std::optional<u64>& value);

  /// Moves to the next row; false at the end.
  bool next();
  /// For statements that give no rows.
  void run();

  /// The next column of this row.
  std::string read_text();
  u64 read_integer();
  double read_number();
  bool is_null() const;
  std::optional<std::string> read_text_or_null();
  std::optional<u64> read_integer_or_null();

 private:
  void check(int code) const;

  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0, column_ = 0;
};

class Database {
 public:
  /// Opens the file or makes it, for this process alone, with a write-ahead log. Throws DatabaseError.
  explicit Database(const std::filesystem::path& file);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  Statement statement(std::string_view sql) { return Statement(database_, sql); }
  /// One or more statements without values.
  void run(const char* sql);

 private:
  sqlite3* database_ = nullptr;
};

/// Everything until `commit`, or nothing.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) { database_.run("BEGIN IMMEDIATE"); }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool committed_ = false;
};

}  // namespace raywalk::store
