// Names and shares.
#include "tests/accuracy/at_scale/run.h"

#include <cmath>

#include "server/device/knobs.h"

namespace raywalk::at_scale {

u64 Run::part_of(double full) const {
  return static_cast<u64>(std::ceil(full * settings.share / settings.threads));
}

std::string name_of(const accuracy::Technique& technique) {
  const std::string_view intersector = intersector_rows()[knobs_of(technique.kernel).intersector].name;
  return technique.structure + "/" + technique.traversal + " " + std::string(intersector);
}

}  // namespace raywalk::at_scale
