// Who stands where.
#include "scenes/robots/parts.h"

namespace raywalk::robots {
namespace {

Joint standing(float x, float z, double facing) {
  return Joint{{x, 0.0f, z}}.yawed(facing);
}

}  // namespace

void add_robots(Pieces& pieces) {
  // In the street, coming and going; two that meet, and one that waves from the square.
  add_biped(pieces, standing(-6.0f, 96.0f, 0.03), 1.0f, kYellow, kSteel, {0.085, 0.06, 0.02, 0.10, 0.16, 0.04});
  add_biped(pieces, standing(9.0f, 84.0f, -0.06), 0.92f, kOrange, kWhite, {0.05, -0.03, 0.05, 0.06, 0.22, -0.06});
  add_biped(pieces, standing(1.0f, 52.0f, 0.46), 1.08f, kWhite, kBlue, {0.07, 0.05, -0.04, 0.12, 0.08, 0.02});
  add_biped(pieces, standing(-15.0f, 58.0f, 0.20), 1.0f, kBlue, kYellow, {0.02, 0.14, 0.10, 0.12, 0.16, 0.05});
  add_biped(pieces, standing(-5.0f, 62.0f, 0.69), 0.95f, kOrange, kSteel, {0.03, 0.20, 0.02, 0.06, 0.18, -0.05});
  add_biped(pieces, standing(18.0f, 20.0f, -0.05), 1.25f, kWhite, kOrange, {0.09, -0.02, 0.07, 0.10, 0.10, 0.03});
  add_biped(pieces, standing(-58.0f, 6.0f, 0.16), 1.1f, kYellow, kBlue, {0.0, 0.40, 0.02, 0.08, 0.12, 0.06});
  add_biped(pieces, standing(-10.0f, -60.0f, 0.02), 1.0f, kWhite, kYellow, {0.08, 0.04, -0.03, 0.10, 0.09, 0.0});
  add_biped(pieces, standing(12.0f, -120.0f, 0.0), 1.3f, kBlue, kWhite, {0.06, 0.02, 0.03, 0.15, 0.12, -0.04});
  add_crawler(pieces, standing(4.0f, 104.0f, 0.10), 1.0f, kWhite, 0.1);
  add_crawler(pieces, standing(-24.0f, 30.0f, 0.62), 1.5f, kYellow, 0.4);
  add_crawler(pieces, standing(14.0f, -20.0f, 0.93), 1.2f, kOrange, 0.7);
}

}  // namespace raywalk::robots
