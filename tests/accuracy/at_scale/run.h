// What the parts of a run share, and the parts.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "server/accuracy/cases/hard_cases.h"
#include "server/device/device_queue.h"
#include "tests/accuracy/at_scale/table.h"

namespace raywalk::at_scale {

struct Settings {
  double share = 1.0;  // of the full numbers
  u32 threads = 1;     // that make rays and judge answers; each has its own random numbers
  u64 seed = 1;
  std::vector<std::string> scenes = {"bunny", "robots", "conference"};
  std::filesystem::path scenes_dir, data_dir;
};

struct Run {
  Settings settings;
  DeviceQueue& queue;
  std::vector<accuracy::Technique> techniques;  // the strict ones of the device
  Table& table;

  /// Of a worker, different for each and for each seed.
  u64 seed_of(u32 worker) const { return (settings.seed - 1) * settings.threads + worker + 1; }
  /// The worker's part of `full` things, rounded up.
  u64 part_of(double full) const;
};

// cases.cpp: 1e8 rays a technique from inside closed meshes; 1e9 spawned rays of all techniques together.
void ask_edges(Run& run);
void ask_vertices(Run& run);
void ask_spawned(Run& run);
// brute.cpp: 1e9 closest hits of all techniques together are those of brute force.
void ask_brute(Run& run);
// slabs.cpp: 1e8 hits of a triangle lie in its box, for each box test.
void ask_slabs(Run& run);
// visits.cpp: padded boxes cost at most 1 % more visits of nodes than plain ones.
void ask_visits(Run& run);
/// Throws Refusal for a scene that the catalogue lacks.
void check_scenes(const Settings& settings);

/// Such as "bvh/while-while exact".
std::string name_of(const accuracy::Technique& technique);

}  // namespace raywalk::at_scale
