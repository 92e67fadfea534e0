// The gate: a row is closed when what it timed was right enough for its tier on the compared frames, else open.
#pragma once
#include <optional>
#include <string>

#include "server/bench/errors.h"
#include "server/bench/knob_choice.h"

namespace raywalk {

/// What a row is held to.
struct GateTerms {
  std::string tier;                 // strict, fast, auto, custom; empty for a technique without knobs
  std::optional<double> limit_ppm;  // of wrong rays; none: nothing is promised, the error is stated alone
};

struct Gate {
  GateTerms terms;
  bool is_open = true;
  std::string reason;                // one sentence for people
  std::optional<KnobChoice> choice;  // of tier auto
};

/// `samples` are times that were measured.
Gate decide_gate(const GateTerms& terms, const ErrorFigures& error, u64 samples);

/// "3 wrong of 4,194,304 rays".
std::string wrong_of_text(u64 wrong, u64 rays);

}  // namespace raywalk
