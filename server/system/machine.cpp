// The machine as Linux tells it.
#include "server/system/machine.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <thread>

#include "server/system/build_info.h"

namespace raywalk {
namespace {

const std::string kUnknown = "unknown";

/// What follows `key` and the separator on the first line that starts with `key`.
std::string value_in(const char* file, const std::string& key, char separator) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    std::size_t begin = line.find(separator);
    if (begin == std::string::npos) continue;
    begin = line.find_first_not_of(" \t\"", begin + 1);
    if (begin == std::string::npos) continue;
    const std::size_t end = line.find_last_not_of(" \t\"");
    return line.substr(begin, end - begin + 1);
  }
  return kUnknown;
}

std::string first_line(const char* file) {
  std::ifstream in(file);
  std::string line;
  return std::getline(in, line) && !line.empty() ? line : kUnknown;
}

std::string fingerprint_of(const Machine& m) {
  std::string text;
  for (const std::string& part : {m.cpu, std::to_string(m.cores), std::to_string(m.threads), m.governor, m.device,
                                  m.compiler, m.build_type, m.build_flags}) {
    text += part + '\n';
  }
  for (const auto& [name, value] : m.device_details) text += name + '=' + value + '\n';
  u64 hash = 14695981039346656037ull;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<u8>(c)) * 1099511628211ull;
  char out[24];
  std::snprintf(out, sizeof out, "%016llx", hash);
  return out;
}

}  // namespace

Machine describe_machine(const std::string& device, const std::map<std::string, std::string>& device_details,
                         u32 threads) {
  Machine m;
  utsname names{};
  uname(&names);
  m.hostname = names.nodename;
  m.kernel = names.release;
  m.os = value_in("/etc/os-release", "PRETTY_NAME", '=');
  m.cpu = value_in("/proc/cpuinfo", "model name", ':');
  m.cores = std::max(1u, std::thread::hardware_concurrency());
  m.threads = threads;
  m.memory_bytes = static_cast<u64>(sysconf(_SC_PHYS_PAGES)) * static_cast<u64>(sysconf(_SC_PAGE_SIZE));
  m.governor = first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  m.device = device;
  m.device_details = device_details;
  m.compiler = build_info::kCompiler;
  m.build_type = build_info::kBuildType;
  m.build_flags = build_info::kFlags;
  m.version = build_info::kVersion;
  m.git_commit = build_info::kGitCommit;
  m.libraries = build_info::libraries();
  m.fingerprint = fingerprint_of(m);
  return m;
}

}  // namespace raywalk
