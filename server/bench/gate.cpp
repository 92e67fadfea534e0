// Counts against limits, and the words for it.
#include "server/bench/gate.h"

#include <cstdio>

namespace raywalk {
namespace {

std::string grouped(u64 count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

std::string brief(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// "2 leaks, 1 wrong id"; `rays` says whose they are.
void list_wrong(const RayVerdicts& verdicts, const std::string& rays, std::string& text) {
  const auto add = [&](u64 count, const std::string& one, const std::string& many) {
    if (count > 0)
      text += (text.empty() ? "" : ", ") + grouped(count) + " " + (count == 1 ? one : many) + " of " + rays;
  };
  add(verdicts.leaks, "leak", "leaks");
  add(verdicts.false_misses, "false miss", "false misses");
  add(verdicts.false_hits, "false hit", "false hits");
  add(verdicts.wrong_ids, "wrong triangle", "wrong triangles");
  add(verdicts.self_hits, "self-hit", "self-hits");
}

std::string limit_text(const GateTerms& terms) {
  if (!terms.limit_ppm) return "the technique has no knobs, so no tier and no limit";
  const std::string whose = terms.tier == "custom" ? "the tier that was asked for" : "tier " + terms.tier;
  return whose + " allows " + (*terms.limit_ppm > 0 ? brief(*terms.limit_ppm) + " ppm" : "none");
}

}  // namespace

std::string wrong_of_text(u64 wrong, u64 rays) {
  return grouped(wrong) + " wrong of " + grouped(rays) + " rays";
}

Gate decide_gate(const GateTerms& terms, const ErrorFigures& error, u64 samples) {
  Gate gate{.terms = terms, .reason = {}, .choice = {}};
  if (samples == 0) {
    gate.reason = "no frame was measured before the time limit.";
    return gate;
  }
  if (error.checked_rays() == 0) {
    gate.reason = "no frame was compared with the reference.";
    return gate;
  }
  gate.is_open = terms.limit_ppm && error.wrong_ppm() > *terms.limit_ppm;
  gate.reason = wrong_of_text(error.wrong_rays(), error.checked_rays());
  if (error.wrong_rays() > 0) {
    std::string kinds;
    list_wrong(error.primary, "primary rays", kinds);
    list_wrong(error.shadow, "shadow rays", kinds);
    gate.reason += " (" + brief(error.wrong_ppm()) + " ppm: " + kinds + ")";
  }
  gate.reason += "; " + limit_text(terms) + ".";
  return gate;
}

}  // namespace raywalk
