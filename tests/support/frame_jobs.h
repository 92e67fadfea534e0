// Frames that several devices are asked for.
#pragma once
#include <cstdlib>
#include <filesystem>

#include "server/device/device.h"

namespace raywalk::test {

/// Inside the room of rooms.h; neither side is a multiple of the block's.
inline FrameJob room_job(const std::shared_ptr<const Structure>& structure, const std::string& traversal, Mode mode) {
  FrameJob job;
  job.structure = structure;
  job.traversal = traversal;
  job.camera = {{0.1f, 0.2f, 1.8f}, {0.0f, -0.4f, 0.0f}, {0, 1, 0}, 70};
  job.width = 83;
  job.height = 45;
  job.mode = mode;
  job.depth = 3;
  return job;
}

/// The original bunny, where the scene data are; it may be missing.
inline std::filesystem::path data_file(const char* place) {
  const char* data = std::getenv("RAYWALK_SCENE_DATA");
  return std::filesystem::path(data ? data : "scenes/data") / place;
}
inline std::filesystem::path bunny_file() {
  return data_file("bunny/bun_zipper.ply");
}

/// The whole bunny, or the dragon, 512 x 512.
inline FrameJob bunny_job(const Box& bounds, const std::shared_ptr<const Structure>& structure,
                          const std::string& traversal) {
  FrameJob job = room_job(structure, traversal, Mode::primary);
  job.width = job.height = 512;
  job.camera = {bounds.centre() + Vec3{0.05f, 0.06f, 0.22f}, bounds.centre(), {0, 1, 0}, 45};
  return job;
}

}  // namespace raywalk::test
