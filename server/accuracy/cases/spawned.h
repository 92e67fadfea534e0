// Where a technique lets rays start that leave a surface.
#pragma once
#include "kernels/shade/surface.h"
#include "server/accuracy/cases/hard_cases.h"

namespace raywalk::accuracy {

/// By the technique's knob `spawn`, the default one where it has none.
Vec3 spawn_origin(const Technique& technique, const Surface& surface, Vec3 d);

}  // namespace raywalk::accuracy
