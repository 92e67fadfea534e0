// Every seed and every sample file of every format, through the same function that the fuzzers call.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "tests/fuzz/formats.h"

namespace raywalk::fuzz {
namespace {

struct Case {
  const NamedFormat* format;
  std::filesystem::path file;
};

/// A test's name may hold letters, digits and underscores.
std::string test_name(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.format->name + "_" + info.param.file.filename().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name + "_" + std::to_string(info.index);
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const NamedFormat& format : named_formats()) {
    for (const char* folder : {RAYWALK_TESTS_DIR "/fuzz/corpus/", RAYWALK_TESTS_DIR "/scene/data/"}) {
      const std::filesystem::path place = folder + format.name;
      if (!std::filesystem::is_directory(place)) continue;
      for (const auto& entry : std::filesystem::recursive_directory_iterator(place)) {
        if (entry.is_regular_file()) all.push_back({&format, entry.path()});
      }
    }
  }
  std::sort(all.begin(), all.end(), [](const Case& a, const Case& b) { return a.file < b.file; });
  return all;
}

class Replay : public testing::TestWithParam<Case> {};

TEST_P(Replay, FailsInNoOtherWayThanARuntimeError) {
  std::ifstream file(GetParam().file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(file.bad());
  try_load(*GetParam().format->format, {reinterpret_cast<const u8*>(bytes.data()), bytes.size()});
}

INSTANTIATE_TEST_SUITE_P(Seeds, Replay, testing::ValuesIn(cases()), test_name);

TEST(Fuzz, EveryFormatHasSeeds) {
  const std::vector<Case> all = cases();
  for (const NamedFormat& format : named_formats()) {
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Case& c) { return c.format->name == format.name; }))
        << format.name;
  }
}

TEST(Fuzz, AnUnknownFormatIsRefused) {
  EXPECT_THROW(format_named("none"), std::invalid_argument);
}

}  // namespace
}  // namespace raywalk::fuzz
