// Fastest first, but what is within the noise goes to the strictest.
#include "server/bench/knob_choice.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "server/bench/gate.h"

namespace raywalk {
namespace {

bool may_pass(const Candidate& candidate) {
  return !candidate.checked || candidate.checked->wrong == 0;
}

/// The strictest of those that are as fast as the fastest one that may still pass; null when none is left. The
/// candidates are sorted by time.
Candidate* next_of(std::vector<Candidate>& candidates) {
  const auto fastest = std::ranges::find_if(candidates, may_pass);
  Candidate* best = nullptr;
  for (auto it = fastest; it != candidates.end() && it->frame_ms <= kNoise * fastest->frame_ms; ++it) {
    if (may_pass(*it) && (!best || it->changed < best->changed)) best = &*it;
  }
  return best;
}

std::string faster_text(const Candidate& candidate, const Candidate& strict) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2fx the speed of ", strict.frame_ms / candidate.frame_ms);
  return candidate.name + ": " + text + strict.name + ", " +
         wrong_of_text(candidate.checked->wrong, candidate.checked->rays);
}

std::string reason_of(const KnobChoice& choice, const Candidate& strict, bool passed) {
  const Candidate& chosen = choice.candidates[choice.chosen];
  std::string refused;
  for (const Candidate& one : choice.candidates) {
    if (one.checked && one.checked->wrong > 0) refused += "; " + faster_text(one, strict) + ", refused";
  }
  if (!passed) return strict.name + ", since nothing passes" + refused + ".";
  if (chosen.changed > 0) return faster_text(chosen, strict) + ", chosen" + refused + ".";
  return strict.name + ": " + wrong_of_text(0, chosen.checked->rays) +
         ", and nothing without a wrong ray is faster by more than 3.5 %" + refused + ".";
}

}  // namespace

KnobChoice choose(std::vector<Candidate> candidates, const std::function<WrongRays(const Candidate&)>& check) {
  if (candidates.empty() || candidates.front().changed != 0) throw std::logic_error("strict is not the first");
  const Candidate base = candidates.front();
  std::ranges::stable_sort(candidates, {}, &Candidate::frame_ms);
  Candidate* best = nullptr;
  while ((best = next_of(candidates)) && !best->checked) best->checked = check(*best);

  KnobChoice choice;
  const bool passed = best != nullptr;
  const auto strict = std::ranges::find(candidates, 0u, &Candidate::changed);
  choice.chosen = static_cast<std::size_t>(passed ? best - candidates.data() : strict - candidates.begin());
  choice.candidates = std::move(candidates);
  choice.reason = reason_of(choice, base, passed);
  return choice;
}

}  // namespace raywalk
