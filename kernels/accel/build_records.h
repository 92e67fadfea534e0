// Host only: the builders' side of records.h.
#pragma once
#include <span>

#include "kernels/accel/kind.h"
#include "kernels/accel/records.h"

namespace raywalk {

/// The option `triangles`, the same for all kinds.
Option triangles_option();
/// Its value among complete options.
TriangleRecords triangles_of(const OptionValues& options);

/// Transforms of all triangles by id into `transforms`, which is empty unless the structure holds some.
void write_transforms(SceneView scene, std::span<Transform> transforms);

}  // namespace raywalk
