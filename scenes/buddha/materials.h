// The statue's materials, in the order of its scene.json.
#pragma once
#include "kernels/platform.h"

namespace raywalk::buddha {

enum Material : u32 {
  kSkin,
  kRobe,
  kHair,
  kLotus,
  kBase,
};

}  // namespace raywalk::buddha
