// The city's materials, in the order of its scene.json.
#pragma once
#include "kernels/platform.h"

namespace raywalk::city {

enum Material : u32 {
  kAsphalt,
  kPavement,
  kGrass,
  kMarking,
  kConcrete,
  kSandstone,
  kBrick,
  kDarkPanel,
  kRoof,
  kWindow,
  kTrunk,
  kLeaf,
  kMetal,
  kLamp,
  kCarRed,
  kCarBlue,
  kCarWhite,
  kRubber,
  kBronze,
  kChrome,
};

}  // namespace raywalk::city
