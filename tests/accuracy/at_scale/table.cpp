// Rows as text.
#include "tests/accuracy/at_scale/table.h"

#include <cstdio>

namespace raywalk::at_scale {

void Table::print_head() const {
  std::printf("%-9s %-36s %14s %12s %8s\n", "part", "technique", "rays", "failures", "seconds");
}

void Table::add(const Row& row) {
  failed_ = failed_ || (row.strict && (row.failures != 0 || row.rays == 0));
  std::printf("%-9s %-36s %14llu %12llu %8.1f  %s%s\n", row.part.c_str(), row.technique.c_str(), row.rays, row.failures,
              row.seconds, row.note.c_str(), row.strict ? "" : "(not strict)");
  if (row.strict && !row.first_failure.empty()) std::printf("          %s\n", row.first_failure.c_str());
  std::fflush(stdout);
}

}  // namespace raywalk::at_scale
