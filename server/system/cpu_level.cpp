// Refuses to start on a processor below the level that the daemon is compiled for, before any such instruction runs.
// This file alone is compiled for the baseline x86-64.
#include <unistd.h>

namespace {

constexpr int kExitCode = 5;

bool has_level() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2");
}

/// Runs before the constructors of all other files.
__attribute__((constructor(101))) void check_level() {
  if (has_level()) return;
  constexpr char kText[] =
      "raywalkd: this processor lacks AVX2, FMA or BMI; a processor of level x86-64-v3 is needed.\n";
  if (write(STDERR_FILENO, kText, sizeof kText - 1) < 0) _exit(kExitCode);
  _exit(kExitCode);
}

}  // namespace
