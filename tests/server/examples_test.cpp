// The daemon's validator agrees with every example of the contract; the Python tests read the same files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "server/http/contract.h"
#include "server/http/parse_json.h"

namespace raywalk::http {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(Examples, AreTakenAndRefusedAsTheirNamesSay) {
  const Contract contract(embedded_contract());
  int good = 0, bad = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RAYWALK_EXAMPLES_DIR)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() != ".json") continue;
    const std::string name = path.filename().string();
    const std::string schema = name.substr(0, name.find('.'));
    const Json json = parse_json(text_of(path));
    if (name.find(".good.") != std::string::npos) {
      const auto offences = contract.schema(schema).check(json);
      EXPECT_TRUE(offences.empty()) << name << ": " << offences.front().pointer << " " << offences.front().detail;
      ++good;
    } else {
      const auto offences = contract.schema(schema).check(json.at("instance"));
      const std::string expected = json.at("pointer");
      EXPECT_TRUE(std::any_of(offences.begin(), offences.end(),
                              [&](const auto& offence) { return offence.pointer == expected; }))
          << name << ": no offence at '" << expected << "', but " << offences.size() << " others";
      ++bad;
    }
  }
  EXPECT_GE(good, 20);
  EXPECT_GE(bad, 20);
}

}  // namespace
}  // namespace raywalk::http
