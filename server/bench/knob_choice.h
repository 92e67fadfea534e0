// Tier auto: which of several sets of knobs, from their times and errors.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kernels/accel/kind.h"

namespace raywalk {

/// Times closer than this are taken for equal.
constexpr double kNoise = 1.035;

struct WrongRays {
  u64 wrong = 0, rays = 0;
};

struct Candidate {
  OptionValues kernel;  // complete
  std::string name;     // the knobs that are not strict, or "strict"; "as given" where knobs were fixed by name
  u32 changed = 0;      // their number: the fewer, the stricter
  double frame_ms = 0;
  std::optional<WrongRays> checked = {};  // only where it mattered
};

struct KnobChoice {
  std::vector<Candidate> candidates;  // fastest first
  std::size_t chosen = 0;             // one of them
  std::string reason;                 // one sentence for people
};

/// The fastest of the candidates without a wrong ray; among those within kNoise of it the strictest. The strict one,
/// which must be the first, when all have wrong rays. `check` is asked for as few of them as can be.
KnobChoice choose(std::vector<Candidate> candidates, const std::function<WrongRays(const Candidate&)>& check);

}  // namespace raywalk
