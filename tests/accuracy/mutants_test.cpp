// The hard cases fail each kernel that is broken on purpose, and pass the same kernel as it is.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>

namespace {

struct Mutant {
  std::string name, cases, structure, traversal;
  std::string rays = "0.02";  // of the full number
};

struct Ended {
  int exit_code;
  std::string output;
};

/// Runs a program of the folder `mutants` beside this one on a few of the rays.
Ended run(const std::string& program, const Mutant& mutant) {
  const auto folder = std::filesystem::canonical("/proc/self/exe").parent_path() / "mutants";
  std::ostringstream command;
  command << folder / program << " " << mutant.cases << " " << mutant.rays << " " << mutant.structure << " "
          << mutant.traversal << " 2>&1";
  Ended ended{-1, ""};
  FILE* pipe = popen(command.str().c_str(), "r");
  if (pipe == nullptr) return ended;
  std::array<char, 4096> part;
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe)) ended.output.append(part.data(), size);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) ended.exit_code = WEXITSTATUS(status);
  return ended;
}

std::ostream& operator<<(std::ostream& out, const Mutant& mutant) {
  return out << mutant.name;
}

class Mutants : public testing::TestWithParam<Mutant> {};

TEST_P(Mutants, FailTheHardCases) {
  const Ended broken = run(GetParam().name, GetParam());
  EXPECT_EQ(broken.exit_code, 1) << broken.output;
  EXPECT_NE(broken.output.find("ray o ("), std::string::npos) << broken.output;
  std::printf("%s", broken.output.c_str());
  const Ended original = run("original", GetParam());
  EXPECT_EQ(original.exit_code, 0) << original.output;
}

INSTANTIATE_TEST_SUITE_P(All, Mutants,
                         testing::Values(Mutant{"moeller_trumbore", "1,2", "bvh", "while-while"},
                                         Mutant{"contracted", "2,3", "brute", "loop"},
                                         Mutant{"clamped_inverse", "9,10,15", "bvh", "while-while"},
                                         Mutant{"truncated_stack", "1", "bvh", "while-while"},
                                         Mutant{"accumulated_distance", "17", "grid", "dda", "1"}),
                         [](const testing::TestParamInfo<Mutant>& mutant) { return mutant.param.name; });

}  // namespace
