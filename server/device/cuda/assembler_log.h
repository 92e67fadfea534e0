// What the assembler (ptxas) writes of each entry point when it is asked to be verbose.
#pragma once
#include <string_view>
#include <vector>

#include "server/device/cuda/compiler.h"

namespace raywalk::cuda {

/// One report for each entry point that the log tells of, in order of their names.
std::vector<EntryReport> read_assembler_log(std::string_view log);

}  // namespace raywalk::cuda
