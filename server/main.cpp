// raywalkd: flags -> objects -> routes -> listen; no logic.
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <thread>

#include "server/api/job_store.h"
#include "server/api/residency.h"
#include "server/api/services.h"
#include "server/compile_kernels.h"
#include "server/exit_codes.h"
#include "server/flags.h"
#include "server/http/server.h"
#include "server/jobs/run_job.h"
#include "server/open_devices.h"
#include "server/store/folder_lock.h"
#include "server/supervise.h"
#include "server/system/logging.h"
#include "server/system/shutdown.h"

namespace raywalk {
namespace {

/// Ends the program with one sentence for the person who started it.
struct Fatal {
  int code;
  std::string sentence;
};

/// What references of errors are made with beside a GPU.
struct HostEngine {
  explicit HostEngine(Device& device) : queue(device), structures(queue, device.kinds()) {}
  DeviceQueue queue;
  Structures structures;
};

bool is_loopback(const std::string& host) {
  return host == "localhost" || host == "::1" || host.starts_with("127.");
}

void check_flags(const Flags& flags) {
  if (!is_loopback(flags.host)) {
    throw Fatal{kBadSetting, "The daemon listens on loopback addresses only: '" + flags.host +
                                 "' would be open to the network without access control."};
  }
  if (!std::filesystem::is_directory(flags.scenes_dir)) {
    throw Fatal{kBadSetting,
                "There is no folder of scenes at " + flags.scenes_dir.string() + "; name it with --scenes."};
  }
}

std::filesystem::path make_upload_dir(const std::filesystem::path& state_dir) {
  const std::filesystem::path dir = state_dir / "uploads";
  std::error_code error;
  std::filesystem::create_directories(dir, error);
  if (error || access(dir.c_str(), W_OK | X_OK) != 0) {
    throw Fatal{kBadSetting,
                "The state folder " + state_dir.string() + " cannot be written; name another with --state."};
  }
  return dir;
}

void write_port_file(const std::filesystem::path& path, int port) {
  if (path.empty()) return;
  std::filesystem::path partial = path;
  partial += ".new";
  std::ofstream(partial) << port << '\n';
  std::error_code error;
  std::filesystem::rename(partial, path, error);
  if (error) throw Fatal{kBadSetting, "The port file " + path.string() + " cannot be written."};
}

int run(const Flags& flags) {
  check_flags(flags);
  const std::filesystem::path upload_dir = make_upload_dir(flags.state_dir);
  const store::FolderLock lock(flags.state_dir);
  store::Store store(flags.state_dir);

  const Devices devices = open_devices(flags, store.crashed_device());
  Device& device = *devices.rendering;
  DeviceQueue queue(device, {.on_lost = [](const std::string& cause) {
                      spdlog::critical("the device is lost: {}", cause);
                      shut_down_soon(kDeviceLost);
                    }});
  api::Residency residency(store, device.kinds());
  Structures structures(queue, device.kinds(),
                        [&](const StructureRecord& record) { residency.structure_changed(record); });
  std::optional<HostEngine> host;
  if (devices.reference) host.emplace(*devices.reference);
  Structures& reference_structures = host ? host->structures : structures;
  Scenes scenes(flags.scenes_dir, flags.data_dir, [&](const std::string& name, const ScenePtr& now) {
    structures.evict_scene(name, now);
    if (host) host->structures.evict_scene(name, now);
    residency.scene_changed(name, now);
  });
  const Machine machine = describe_machine(device.info().name, device.info().details, device.info().threads);
  const Workplace place{scenes, structures, queue, reference_structures, host ? host->queue : queue, machine};
  api::JobStore job_store(store, device.kinds());
  JobQueue jobs([&](const JobSpec& spec, const auto& report) { return run_job(spec, place, report); }, job_store,
                job_store.recover(), [&] { return queue.lost().has_value(); });

  const http::Contract contract(http::embedded_contract());
  api::Metrics metrics;
  const http::ServerConfig config{
      .host = flags.host, .port = flags.port, .upload_dir = upload_dir, .site = http::embedded_site()};
  api::Services services{contract, config.limits, machine,    flags.device, devices.no_cuda, devices.warnings,
                         queue,    scenes,        structures, jobs,         store,           metrics};
  http::Server server(config, http::Router(contract, api::routes(services)),
                      [&](const http::Exchange& exchange) { metrics.observe(exchange); });

  const int port = server.bind();
  write_port_file(flags.port_file, port);
  store.begin_session(device.info().kind);
  residency.begin();
  const ShutdownWatch watch([&] {
    if (shutdown_exit_code() == kDone) store.end_session();
    server.stop();
  });
  const std::jthread restoring([&](const std::stop_token& stop) {
    residency.restore(scenes, structures, stop);
    jobs.start();  // they find the scenes that their clients had loaded
  });
  std::printf("listening on http://%s:%d\n", flags.host.c_str(), port);
  std::fflush(stdout);
  spdlog::info("device=\"{}\" threads={} commit={}", machine.device, machine.threads, machine.git_commit);
  server.serve();
  spdlog::info("stopped");
  return shutdown_exit_code();
}

}  // namespace
}  // namespace raywalk

int main(int argc, char** argv) {
  using namespace raywalk;
  const auto [flags, exit_code] = parse_flags(argc, argv);
  if (exit_code) return *exit_code;
  if (flags.compile_kernels.empty()) block_shutdown_signals();  // before any thread starts
  if (flags.die_with_parent) prctl(PR_SET_PDEATHSIG, SIGTERM);
  set_up_logging(flags.log_level, flags.log_json);
  if (!flags.compile_kernels.empty()) return compile_kernels(flags.compile_kernels, flags.kernel_cache_dir);
  try {
    if (flags.supervise) return supervise({argv, argv + argc}, flags.host, flags.port);
    return run(flags);
  } catch (const Fatal& fatal) {
    std::fprintf(stderr, "raywalkd: %s\n", fatal.sentence.c_str());
    return fatal.code;
  } catch (const store::FolderError& e) {
    std::fprintf(stderr, "raywalkd: %s\n", e.what());
    return kBadSetting;
  } catch (const NoDevice& e) {
    std::fprintf(stderr, "raywalkd: %s\n", e.what());
    return kNoDevice;
  } catch (const http::PortInUse& e) {
    std::fprintf(stderr, "raywalkd: %s\n", e.what());
    return kPortInUse;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "raywalkd: %s\n", e.what());
    return kFailed;
  }
}
