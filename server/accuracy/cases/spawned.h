// Where a technique lets rays start that leave a surface.
#pragma once
#include "server/accuracy/cases/hard_cases.h"
#include "server/device/knobs.h"

namespace raywalk::accuracy {

/// By the technique's knob `spawn`, the default one where it has none.
SpawnOrigin spawn_origin_of(const Technique& technique);

}  // namespace raywalk::accuracy
