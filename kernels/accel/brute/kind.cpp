// The kind "brute": the linear loop reads the scene itself, or transforms of its triangles.
#include "kernels/accel/brute/kind.h"

#include <chrono>

#include "kernels/accel/brute/traverse.h"
#include "kernels/accel/build_records.h"

namespace raywalk::brute {

namespace {

BuiltStructure build(SceneView scene, const OptionValues& options) {
  const auto start = std::chrono::steady_clock::now();
  BuiltStructure built{Blob(0), {}, {triangles_of(options)}};
  if (built.form.triangles == TriangleRecords::transforms) {
    BlobPlan plan(sizeof(Header));
    const Header header{plan.add<Transform>(scene.triangle_count())};
    built.blob = plan.allocate();
    std::memcpy(built.blob.data(), &header, sizeof header);
    write_transforms(scene, slice_of(built.blob, header.transforms));
  }
  built.stats.references = scene.triangle_count();
  built.stats.size_bytes = built.blob.size_bytes();
  built.stats.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return built;
}

}  // namespace

const Kind& kind() {
  static const Kind brute{"brute", "no structure: every ray meets every triangle", {triangles_option()}, build};
  return brute;
}

}  // namespace raywalk::brute
