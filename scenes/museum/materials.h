// The museum's materials, in the order of its scene.json.
#pragma once
#include "kernels/platform.h"

namespace raywalk::museum {

enum Material : u32 {
  kLightTile,
  kDarkTile,
  kWall,
  kDado,
  kPlaster,
  kMarble,
  kGold,
  kCanvas,
  kSky,
  kPaleSky,
  kSun,
  kFarHill,
  kHill,
  kMeadow,
  kRed,
  kBlue,
  kYellow,
  kBlack,
  kMirror,
  kBronze,
  kPlinth,
  kBrass,
  kRope,
  kLeather,
  kGlass,
  kChrome,
};

}  // namespace raywalk::museum
