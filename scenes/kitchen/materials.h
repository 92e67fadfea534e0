// The kitchen's materials, in the order of its scene.json.
#pragma once
#include "kernels/platform.h"

namespace raywalk::kitchen {

enum Material : u32 {
  kLightTile,
  kDarkTile,
  kWall,
  kCeiling,
  kTrim,
  kCupboard,
  kPanel,
  kPlinth,
  kWorktop,
  kWallTile,
  kWallTileAccent,
  kSteel,
  kChrome,
  kBlackGlass,
  kEnamel,
  kIron,
  kTableWood,
  kLeather,
  kPlate,
  kGlass,
  kBottle,
  kOrange,
  kApple,
  kLemon,
  kLeaf,
  kPot,
  kCopper,
  kShade,
  kBulb,
  kToyRed,
  kToyYellow,
  kRubber,
  kWood,
};

}  // namespace raywalk::kitchen
