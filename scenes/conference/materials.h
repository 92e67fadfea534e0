// The conference room's materials, in the order of its scene.json.
#pragma once
#include "kernels/platform.h"

namespace raywalk::conference {

enum Material : u32 {
  kWall,
  kPanel,
  kCeiling,
  kCarpet,
  kCarpetBorder,
  kTrim,
  kTable,
  kInlay,
  kLeather,
  kShell,
  kChrome,
  kPlastic,
  kCurtain,
  kPane,
  kGlass,
  kPaper,
  kBoard,
  kScreen,
  kBlue,
  kOrange,
  kGreen,
  kMirror,
  kBrass,
  kDiffuser,
  kVent,
  kLeaf,
  kPot,
  kPorcelain,
};

}  // namespace raywalk::conference
