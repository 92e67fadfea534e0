// Asks what the strict tier promises, in numbers that only a GPU answers in minutes, and prints a table. Exits with 1
// when a strict technique failed, 2 when something could not be asked.
//   raywalk_at_scale [--device cpu|cuda] [--share X] [--threads N] [--only edges,brute,...]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "server/system/build_info.h"
#include "server/system/environment.h"
#include "server/system/stopwatch.h"
#include "server/system/time_text.h"
#include "tests/accuracy/at_scale/run.h"

namespace raywalk::at_scale {
namespace {

constexpr int kFailed = 1, kNotAsked = 2;

struct Part {
  const char* name;
  void (*ask)(Run& run);
};
constexpr Part kParts[] = {{"edges", ask_edges}, {"vertices", ask_vertices}, {"spawned", ask_spawned},
                           {"brute", ask_brute}, {"slabs", ask_slabs},       {"visits", ask_visits}};

std::unique_ptr<Device> open(const std::string& kind) {
  if (kind == "cpu") return open_cpu_device(0);
  DeviceOrReason opened = open_cuda_device({});
  if (!opened.device) throw std::runtime_error(opened.why_not);
  return std::move(opened.device);
}

std::vector<accuracy::Technique> strict_techniques(const Device& device) {
  std::vector<accuracy::Technique> all = accuracy::techniques_of(device);
  std::erase_if(all, [](const accuracy::Technique& technique) { return !is_strict(technique); });
  return all;
}

void print_place(const Device& device, const std::vector<std::string>& arguments) {
  std::printf("\n%s, %s", device.info().name.c_str(), device.info().kind.c_str());
  for (const auto& [name, value] : device.info().details) std::printf(", %s %s", name.c_str(), value.c_str());
  std::printf("; commit %s; %s\n", build_info::kGitCommit, now_text().c_str());
  for (const std::string& argument : arguments) std::printf("%s ", argument.c_str());
  std::printf("\n");
}

int run(int count, char** arguments) {
  Settings settings;
  // The device's thread and its builds need processors too.
  settings.threads = std::max(1u, std::thread::hardware_concurrency() / 2);
  settings.scenes_dir = build_info::kScenesDir;
  std::string kind = "cuda";
  std::vector<std::string> names;
  for (const Part& part : kParts) names.emplace_back(part.name);
  std::vector<std::string> only = names;
  CLI::App app("Counts the failures of the strict techniques of a device.");
  app.add_option("--device", kind, "What traces.")->capture_default_str()->check(CLI::IsMember({"cpu", "cuda"}));
  app.add_option("--share", settings.share, "Of the full numbers.")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1e3));
  app.add_option("--threads", settings.threads, "That make rays and judge; their number and the seed decide the rays.")
      ->capture_default_str()
      ->check(CLI::Range(1, 4096));
  app.add_option("--seed", settings.seed, "Of all random numbers.")
      ->capture_default_str()
      ->check(CLI::Range(1, 1 << 20));
  app.add_option("--only", only, "Parts to ask.")->delimiter(',')->check(CLI::IsMember(names));
  app.add_option("--scenes", settings.scenes, "Of the catalogue, for visits.")->delimiter(',')->capture_default_str();
  app.add_option("--scenes-dir", settings.scenes_dir, "Folder of the catalogue.")->capture_default_str();
  app.add_option("--data", settings.data_dir, "Folder of original data (default: $RAYWALK_SCENE_DATA).");
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kNotAsked;
  }
  if (settings.data_dir.empty()) settings.data_dir = environment("RAYWALK_SCENE_DATA");
  if (settings.data_dir.empty()) settings.data_dir = settings.scenes_dir / "data";

  const auto is_asked = [&](const char* part) { return std::ranges::find(only, part) != only.end(); };
  if (is_asked("visits")) check_scenes(settings);  // now, not after minutes
  const std::unique_ptr<Device> device = open(kind);
  DeviceQueue queue(*device, {.capacity = settings.threads + std::size_t{1}});
  Table table;
  Run run{settings, queue, strict_techniques(*device), table};
  table.print_head();
  for (const Part& part : kParts) {
    if (!is_asked(part.name)) continue;
    const Stopwatch watch;
    part.ask(run);
    std::printf("%-9s %-36s %14s %12s %8.1f\n", part.name, "all", "", "", watch.ms() * 1e-3);
    std::fflush(stdout);
  }
  print_place(*device, {arguments, arguments + count});
  return table.failed() ? kFailed : 0;
}

}  // namespace
}  // namespace raywalk::at_scale

int main(int count, char** arguments) {
  try {
    return raywalk::at_scale::run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raywalk_at_scale: %s\n", error.what());
    return raywalk::at_scale::kNotAsked;
  }
}
