// Command line and its defaults.
#include "server/flags.h"

#include <unistd.h>

#include <CLI/CLI.hpp>

#include "server/system/build_info.h"
#include "server/system/environment.h"

namespace raywalk {
namespace {

std::filesystem::path default_state_dir() {
  if (const std::string xdg = environment("XDG_STATE_HOME"); !xdg.empty())
    return std::filesystem::path(xdg) / "raywalk";
  if (const std::string home = environment("HOME"); !home.empty()) {
    return std::filesystem::path(home) / ".local" / "state" / "raywalk";
  }
  return std::filesystem::temp_directory_path() / ("raywalk-" + std::to_string(getuid()));
}

/// Beside the binary (an installed daemon), else in the source tree that it was built from.
std::filesystem::path default_scenes_dir() {
  std::error_code error;
  const std::filesystem::path binary = std::filesystem::read_symlink("/proc/self/exe", error);
  for (const char* relative : {"scenes", "../share/raywalk/scenes"}) {
    const std::filesystem::path candidate = binary.parent_path() / relative;
    if (!error && std::filesystem::is_directory(candidate)) return candidate.lexically_normal();
  }
  return build_info::kScenesDir;
}

}  // namespace

FlagsOrExit parse_flags(int argc, char** argv) {
  Flags flags;
  CLI::App app("Keeps ray-tracing structures resident on one device and serves frames and benchmarks over HTTP.");
  app.option_defaults()->take_last();  // a script's defaults may stand before the flags of its caller
  app.set_version_flag("--version", std::string("raywalkd ") + build_info::kVersion);
  app.add_option("--host", flags.host, "Loopback address to listen on.")->capture_default_str();
  app.add_option("--port", flags.port, "Port; 0 takes any free one.")
      ->capture_default_str()
      ->check(CLI::Range(0, 65535));
  app.add_option("--port-file", flags.port_file, "File that gets the chosen port.");
  app.add_option("--device", flags.device, "What renders.")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "cpu", "cuda"}));
  app.add_option("--state", flags.state_dir,
                 "Folder for the daemon's files, made when missing (default: raywalk in $XDG_STATE_HOME, "
                 "or in .local/state of the home).");
  app.add_option("--kernel-cache", flags.kernel_cache_dir,
                 "Folder for compiled GPU kernels (default: <state>/kernels).");
  app.add_option("--device-memory-mib", flags.device_memory_mib, "Most memory to use of a GPU; 0 takes what it has.")
      ->capture_default_str()
      ->check(CLI::Range(u64{0}, u64{1} << 30));
  app.add_option("--fault-after", flags.fault_after,
                 "For tests: the GPU's kernel launch of this number fails on purpose; 0: none.")
      ->capture_default_str();
  app.add_option("--threads", flags.threads, "Threads that render; 0 takes all processors.")
      ->capture_default_str()
      ->check(CLI::Range(0, 4096));
  app.add_option("--scenes", flags.scenes_dir, "Folder of the scene catalogue.");
  app.add_option("--data", flags.data_dir,
                 "Folder of original scene data (default: $RAYWALK_SCENE_DATA, else <scenes>/data).");
  app.add_option("--log-level", flags.log_level, "Least severe messages to log.")
      ->capture_default_str()
      ->check(CLI::IsMember({"debug", "info", "warn", "error"}));
  app.add_flag("--log-json", flags.log_json, "Log one JSON object a line.");
  app.add_flag("--die-with-parent", flags.die_with_parent, "Stop when the process that started the daemon ends.");
  app.add_option(
         "--compile-kernels", flags.compile_kernels,
         "Compile the GPU's kernels for these architectures, such as sm_80,sm_90, print registers and spills as "
         "JSON, and end; needs no GPU.")
      ->delimiter(',');
  app.add_flag("--supervise", flags.supervise, "Run the daemon in a child process and start it again when it crashes.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int code = app.exit(e);
    return {flags, code == 0 ? 0 : 2};
  }
  if (flags.state_dir.empty()) flags.state_dir = default_state_dir();
  if (flags.kernel_cache_dir.empty()) flags.kernel_cache_dir = flags.state_dir / "kernels";
  if (flags.scenes_dir.empty()) flags.scenes_dir = default_scenes_dir();
  if (flags.data_dir.empty()) flags.data_dir = environment("RAYWALK_SCENE_DATA");
  if (flags.data_dir.empty()) flags.data_dir = flags.scenes_dir / "data";
  return {flags, std::nullopt};
}

}  // namespace raywalk
