// The office's materials, in the order of its scene.json.
#pragma once
#include "kernels/platform.h"

namespace raywalk::office {

enum Material : u32 {
  kWall,
  kAccentWall,
  kCeiling,
  kCarpetLight,
  kCarpetDark,
  kTrim,
  kDesk,
  kWood,
  kPlastic,
  kScreen,
  kScreenBlue,
  kChrome,
  kSteel,
  kLeather,
  kFabric,
  kGlass,
  kPaper,
  kCeramic,
  kLeaf,
  kPot,
  kDiffuser,
  kBrass,
  kMirror,
  kBookRed,
  kBookBlue,
  kBookGreen,
  kBookCream,
  kSea,
};

}  // namespace raywalk::office
