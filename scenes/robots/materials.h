// The materials of the robots and their city, in the order of its scene.json.
#pragma once
#include "kernels/platform.h"

namespace raywalk::robots {

enum Material : u32 {
  kAsphalt,
  kPavement,
  kMarking,
  kConcrete,
  kSandstone,
  kBrick,
  kSlate,
  kTrim,
  kWindow,
  kRoof,
  kYellow,
  kWhite,
  kOrange,
  kBlue,
  kSteel,
  kRubber,
  kVisor,
  kLamp,
  kChrome,
  kLeaf,
};

}  // namespace raywalk::robots
