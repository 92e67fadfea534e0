// The hard cases on the CPU for one technique, as a program of its own: linked with the kernels as they are, or with
// one that was broken on purpose. Exits with 1 and prints the first failure of each case when one fails.
//   original CASES RAYS STRUCTURE TRAVERSAL      such as: original 1,2 0.1 bvh while-while
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "server/accuracy/cases/hard_cases.h"

namespace {

using namespace raywalk;
using namespace raywalk::accuracy;

int run(const std::string& cases, double rays, const Technique& technique) {
  SuiteSpec spec{{technique}, {}, rays};
  std::stringstream list(cases);
  for (std::string number; std::getline(list, number, ',');)
    spec.numbers.push_back(static_cast<u32>(std::atoi(number.c_str())));
  const std::unique_ptr<Device> device = open_cpu_device(0);
  const auto on_device = [&](const std::function<void(Device&)>& work) { work(*device); };
  bool failed = false;
  for (const CaseOutcome& outcome : run_hard_cases(on_device, spec, [](double, const std::string&) {})) {
    std::printf("case %u, %s: %llu of %llu rays fail. %s\n", outcome.number, outcome.title.c_str(), outcome.failures,
                outcome.rays, outcome.first_failure.c_str());
    failed = failed || outcome.failures != 0 || outcome.nans != 0;
  }
  return failed ? 1 : 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 5) {
    std::fprintf(stderr, "usage: %s CASES RAYS STRUCTURE TRAVERSAL\n", arguments[0]);
    return 2;
  }
  return run(arguments[1], std::atof(arguments[2]), {arguments[3], arguments[4]});
}
