// The meshes, scenes and rays of the hard cases, under the name that tests know them by.
#pragma once
#include "server/accuracy/cases/meshes.h"

namespace raywalk::test {

using namespace accuracy;

}  // namespace raywalk::test
