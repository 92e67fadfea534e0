// The printed table: a line for each question, and whether all went as the strict tier promises.
#pragma once
#include <string>

#include "kernels/platform.h"

namespace raywalk::at_scale {

struct Row {
  std::string part, technique;
  u64 rays = 0, failures = 0;
  double seconds = 0;
  std::string note = {};           // a figure beside the counts
  std::string first_failure = {};  // with numbers as hex floats
  bool strict = true;              // else the failures are a figure, not a verdict
};

class Table {
 public:
  void print_head() const;
  /// Prints the row at once. A strict row without rays has failed too.
  void add(const Row& row);
  bool failed() const { return failed_; }

 private:
  bool failed_ = false;
};

}  // namespace raywalk::at_scale
