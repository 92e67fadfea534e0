// The gate, from made-up counts; verdicts into counts; the choice of tier auto, from made-up times and errors.
#include "server/bench/gate.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "kernels/accel/traversals.h"
#include "server/bench/choose_knobs.h"
#include "server/device/knobs.h"

namespace raywalk {
namespace {

using oracle::Verdict;

const GateTerms kStrict{"strict", 0.0}, kFast{"fast", 1.0};

ErrorFigures counted(u64 rays) {
  ErrorFigures error;
  error.primary.rays = rays;
  return error;
}

TEST(Gate, ClosesOnNoWrongRay) {
  const Gate gate = decide_gate(kStrict, counted(4'194'304), 20);
  EXPECT_FALSE(gate.is_open);
  EXPECT_EQ(gate.reason, "0 wrong of 4,194,304 rays; tier strict allows none.");
}

TEST(Gate, OneWrongRayOpensAStrictRow) {
  ErrorFigures error = counted(4'194'304);
  error.primary.leaks = 1;
  const Gate strict = decide_gate(kStrict, error, 20), fast = decide_gate(kFast, error, 20);
  EXPECT_TRUE(strict.is_open);
  EXPECT_EQ(strict.reason, "1 wrong of 4,194,304 rays (0.238 ppm: 1 leak of primary rays); tier strict allows none.");
  EXPECT_FALSE(fast.is_open);
  EXPECT_NE(fast.reason.find("tier fast allows 1 ppm."), std::string::npos) << fast.reason;
}

TEST(Gate, AllKindsOfWrongRaysCount) {
  ErrorFigures error = counted(1'000'000);
  error.primary.false_misses = error.primary.false_hits = error.primary.wrong_ids = 1;
  error.shadow.rays = 1'000'000;
  error.shadow.self_hits = 2;
  EXPECT_EQ(error.wrong_rays(), 5u);
  EXPECT_DOUBLE_EQ(error.wrong_ppm(), 2.5);
  const Gate gate = decide_gate(kFast, error, 1);
  EXPECT_TRUE(gate.is_open);
  EXPECT_NE(gate.reason.find("1 false miss of primary rays, 1 false hit of primary rays, 1 wrong triangle of primary "
                             "rays, 2 self-hits of shadow rays"),
            std::string::npos)
      << gate.reason;
}

TEST(Gate, WhatFloatsCannotTellIsNotWrong) {
  ErrorFigures error = counted(1000);
  for (const Verdict verdict : {Verdict::right, Verdict::tie, Verdict::boundary, Verdict::near}) {
    error.primary.add(verdict, Verdict::leak);
  }
  EXPECT_EQ(error.primary.judged, 4u);
  EXPECT_EQ(error.primary.right, 2u);
  EXPECT_EQ(error.primary.reference_wrong, 4u);
  EXPECT_FALSE(decide_gate(kStrict, error, 1).is_open);
}

TEST(Gate, EveryWrongVerdictIsCountedOnce) {
  RayVerdicts verdicts, sum;
  for (const Verdict verdict : {Verdict::leak, Verdict::false_miss, Verdict::wrong_id, Verdict::false_hit}) {
    verdicts.add(verdict, Verdict::near);
  }
  EXPECT_EQ(verdicts.wrong(), 4u);
  EXPECT_EQ(verdicts.reference_wrong, 0u);
  sum += verdicts;
  sum += verdicts;
  EXPECT_EQ(sum.judged, 8u);
  EXPECT_EQ(sum.leaks, 2u);
  EXPECT_EQ(sum.wrong(), 8u);
}

TEST(Gate, WhatWasNotMeasuredOrNotComparedIsOpen) {
  EXPECT_TRUE(decide_gate(kStrict, counted(100), 0).is_open);
  const Gate gate = decide_gate(kFast, counted(0), 5);
  EXPECT_TRUE(gate.is_open);
  EXPECT_EQ(gate.reason, "no frame was compared with the reference.");
}

TEST(Gate, WithoutATierThereIsNoLimit) {
  ErrorFigures error = counted(1000);
  error.primary.leaks = 500;
  const Gate gate = decide_gate({}, error, 1);
  EXPECT_FALSE(gate.is_open);
  EXPECT_NE(gate.reason.find("no tier and no limit"), std::string::npos) << gate.reason;
}

/// Candidates with these times, each with as many knobs changed as its place says.
std::vector<Candidate> timed(const std::vector<double>& ms) {
  std::vector<Candidate> candidates;
  for (u32 i = 0; i < ms.size(); ++i) {
    candidates.push_back({{}, i == 0 ? "strict" : "set " + std::to_string(i), i, ms[i]});
  }
  return candidates;
}

/// The name of what is chosen when these have wrong rays; writes down who was checked.
std::string chosen_of(const std::vector<double>& ms, const std::vector<std::string>& wrong,
                      std::vector<std::string>* asked = nullptr) {
  const KnobChoice choice = choose(timed(ms), [&](const Candidate& one) {
    if (asked) asked->push_back(one.name);
    return WrongRays{std::ranges::count(wrong, one.name) > 0 ? 3u : 0u, 4'194'304};
  });
  EXPECT_TRUE(std::ranges::is_sorted(choice.candidates, {}, &Candidate::frame_ms));
  return choice.candidates.at(choice.chosen).name;
}

TEST(Choice, TheFastestThatPasses) {
  std::vector<std::string> asked;
  EXPECT_EQ(chosen_of({10, 9, 8}, {}, &asked), "set 2");
  EXPECT_EQ(asked, (std::vector<std::string>{"set 2"})) << "the others do not matter";
  EXPECT_EQ(chosen_of({10, 9, 8}, {"set 2"}), "set 1");
  EXPECT_EQ(chosen_of({10, 9, 8}, {"set 2", "set 1"}), "strict");
  EXPECT_EQ(chosen_of({8, 9, 10}, {}), "strict");
}

TEST(Choice, WithinTheNoiseTheStricterOneWins) {
  EXPECT_EQ(chosen_of({10.3, 10.2, 10}, {}), "strict");
  EXPECT_EQ(chosen_of({10.4, 10.2, 10}, {}), "set 1");
  EXPECT_EQ(chosen_of({10.4, 10.2, 10}, {"set 1"}), "set 2");
  EXPECT_EQ(chosen_of({10.4, 10.5, 10}, {}), "set 2");
}

TEST(Choice, NothingPassesThenItIsStrict) {
  EXPECT_EQ(chosen_of({10, 9, 8}, {"set 2", "set 1", "strict"}), "strict");
  EXPECT_THROW(choose({}, [](const Candidate&) { return WrongRays{}; }), std::logic_error);
}

TEST(Choice, SaysWhy) {
  const auto reason = [](const std::vector<double>& ms, u64 wrong_of_fastest) {
    return choose(timed(ms),
                  [&](const Candidate& one) {
                    return WrongRays{one.frame_ms == ms.back() ? wrong_of_fastest : 0, 4'194'304};
                  })
        .reason;
  };
  EXPECT_EQ(reason({10.6, 10}, 0), "set 1: 1.06x the speed of strict, 0 wrong of 4,194,304 rays, chosen.");
  EXPECT_EQ(reason({10.6, 10}, 2),
            "strict: 0 wrong of 4,194,304 rays, and nothing without a wrong ray is faster by more than 3.5 %; set 1: "
            "1.06x the speed of strict, 2 wrong of 4,194,304 rays, refused.");
}

class CandidatesTest : public testing::Test {
 protected:
  CandidatesTest() {
    const KindInfo kind{"bvh", "", {}, {traversal_}};
    base_ = kernel_options(kind, traversal_, Tier::strict, {}, "");
  }
  TraversalInfo traversal_{"while-while", "", false, knob_options(kKnobSlab)};
  OptionValues base_;
};

TEST_F(CandidatesTest, ComeFromTheOptionsOfTheTraversal) {
  const std::vector<Candidate> singles = single_changes(traversal_, {}, base_, {});
  std::size_t fit = 0;  // intersectors that a structure without transforms takes
  for (u32 i = 0; i < intersector_rows().size(); ++i) fit += why_unfit({}, {{"intersector", i}}).empty();
  EXPECT_LT(fit, intersector_rows().size());
  ASSERT_EQ(singles.size(), 1 + (fit - 1) + (slab_rows().size() - 1)) << "spawn is not tried";
  EXPECT_EQ(singles[0].kernel, base_);
  EXPECT_EQ(singles[0].changed, 0u);
  EXPECT_EQ(singles[1].name, intersector_rows()[1].name);
  EXPECT_EQ(singles.back().name, "plain");
  for (std::size_t i = 1; i < singles.size(); ++i) EXPECT_EQ(singles[i].changed, 1u) << singles[i].name;
  EXPECT_EQ(single_changes(traversal_, {}, base_, {{"intersector", "watertight"}}).size(), slab_rows().size());
}

TEST_F(CandidatesTest, OnlyWhatIsFasterIsCombined) {
  std::vector<Candidate> singles = single_changes(traversal_, {}, base_, {});
  for (Candidate& one : singles) one.frame_ms = one.name == "moeller-trumbore" || one.name == "plain" ? 9 : 10;
  const std::vector<Candidate> sets = combinations(traversal_, singles);
  std::vector<std::string> names;
  for (const Candidate& one : sets) names.push_back(one.name);
  EXPECT_EQ(names, (std::vector<std::string>{"strict", "moeller-trumbore", "plain", "moeller-trumbore, plain"}));
  EXPECT_EQ(sets[3].changed, 2u);
  for (Candidate& one : singles) one.frame_ms = 10;
  EXPECT_EQ(combinations(traversal_, singles).size(), 1u);
}

}  // namespace
}  // namespace raywalk
