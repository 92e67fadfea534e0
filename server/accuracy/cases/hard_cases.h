// The forty hard cases: rays and meshes that broken arithmetic gets wrong, asked of every technique of a device.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "server/device/device.h"

namespace raywalk::accuracy {

/// One structure with one traversal and its knobs; options as Device::build and RayJob take them.
struct Technique {
  std::string structure, traversal;
  OptionValues options = {}, kernel = {};
};

struct SuiteSpec {
  std::vector<Technique> techniques;
  std::vector<u32> numbers;  // of the cases; empty: all
  double rays = 1.0;         // of the full number, such as 0.1
  u64 seed = 1;
};

/// One case with one technique.
struct CaseOutcome {
  u32 number = 0;
  std::string title;
  Technique technique;
  u64 rays = 0, failures = 0;
  u64 nans = 0;               // hits that hold a NaN: wrong whatever the technique
  std::string first_failure;  // the ray and the triangle as hex floats, shrunk; empty when all was right
  std::string why_not;        // why the case says nothing of this technique; empty when it ran
  double ms = 0;
};

/// Every structure with every traversal and every triangle test of the device, the other knobs at their defaults; no
/// bare loops.
std::vector<Technique> techniques_of(const Device& device);

/// Strict cases only hold for the strict knobs: of others the outcome is a figure, not a verdict.
bool is_strict(const Technique& technique);

/// `report` is called before each case of each technique with the fraction done; what it throws ends the run.
/// `on_device` runs work on the device's thread.
std::vector<CaseOutcome> run_hard_cases(const std::function<void(const std::function<void(Device&)>&)>& on_device,
                                        const SuiteSpec& spec,
                                        const std::function<void(double fraction, const std::string& what)>& report);

/// Number and title of each case, 1 to 40.
struct CaseTitle {
  u32 number;
  std::string_view title;
};
const std::vector<CaseTitle>& case_titles();

}  // namespace raywalk::accuracy
