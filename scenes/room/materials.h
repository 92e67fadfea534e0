// The room's materials, in the order of its scene.json.
#pragma once
#include "kernels/platform.h"

namespace raywalk::room {

enum Material : u32 {
  kWall,
  kAccentWall,
  kCeiling,
  kPlankLight,
  kPlank,
  kPlankDark,
  kTrim,
  kWood,
  kFabric,
  kPillow,
  kRug,
  kMirror,
  kGlass,
  kChrome,
  kCeramic,
  kBowl,
  kOrange,
  kApple,
  kLeaf,
  kPot,
  kMetal,
  kShade,
  kBronze,
  kStone,
  kBookRed,
  kBookBlue,
  kBookGreen,
  kBookCream,
};

}  // namespace raywalk::room
