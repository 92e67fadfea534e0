// Reads lines such as
//   ptxas info    : Compiling entry function 'frame' for 'sm_90'
//   ptxas info    : Function properties for frame
//   ptxas         .     0 bytes stack frame, 0 bytes spill stores, 0 bytes spill loads
//   ptxas info    : Used 30 registers, used 1 barriers, 128 bytes smem
#include "server/device/cuda/assembler_log.h"

#include <algorithm>
#include <charconv>

namespace raywalk::cuda {
namespace {

/// The number right before `unit`; 0 when the line has no such unit.
u32 number_before(std::string_view line, std::string_view unit) {
  const size_t end = line.find(unit);
  if (end == std::string_view::npos) return 0;
  const size_t before = line.find_last_not_of("0123456789", end == 0 ? 0 : end - 1);
  const size_t begin = before == std::string_view::npos ? 0 : before + 1;
  u32 value = 0;
  std::from_chars(line.data() + begin, line.data() + end, value);
  return value;
}

/// What follows `key`, up to `end`; empty when the line lacks the key.
std::string_view after(std::string_view line, std::string_view key, char end) {
  const size_t at = line.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = line.substr(at + key.size());
  return rest.substr(0, rest.find(end));
}

}  // namespace

std::vector<EntryReport> read_assembler_log(std::string_view log) {
  std::vector<EntryReport> reports;
  bool of_entry = false;  // functions that an entry calls have properties of their own
  while (!log.empty()) {
    const size_t length = std::min(log.find('\n'), log.size());
    const std::string_view line = log.substr(0, length);
    log.remove_prefix(std::min(length + 1, log.size()));

    if (const std::string_view entry = after(line, "Compiling entry function '", '\''); !entry.empty()) {
      reports.push_back({.entry = std::string(entry)});
      of_entry = true;
    } else if (reports.empty()) {
      continue;
    } else if (const std::string_view function = after(line, "Function properties for ", ' '); !function.empty()) {
      of_entry = function == reports.back().entry;
    } else if (line.find(" bytes stack frame") != std::string_view::npos && of_entry) {
      reports.back().stack_bytes = number_before(line, " bytes stack frame");
      reports.back().spill_store_bytes = number_before(line, " bytes spill stores");
      reports.back().spill_load_bytes = number_before(line, " bytes spill loads");
    } else if (line.find(" registers") != std::string_view::npos) {
      reports.back().registers = number_before(line, " registers");
      reports.back().shared_bytes = number_before(line, " bytes smem");
    }
  }
  std::ranges::sort(reports, {}, &EntryReport::entry);
  return reports;
}

}  // namespace raywalk::cuda
