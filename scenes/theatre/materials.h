// The theatre's materials, in the order of its scene.json.
#pragma once
#include "kernels/platform.h"

namespace raywalk::theatre {

enum Material : u32 {
  kWall,
  kPanel,
  kCeiling,
  kCarpet,
  kBoards,
  kWood,
  kGold,
  kVelvet,
  kSeat,
  kSeatShell,
  kBackdrop,
  kIvory,
  kLacquer,
  kBrass,
  kCrystal,
  kFlame,
  kLampMetal,
  kLens,
  kMirror,
  kDoor,
};

}  // namespace raywalk::theatre
