// Specs and results as JSON: as the contract has them, and nothing lost.
#include "server/api/wire.h"

#include <gtest/gtest.h>

#include "server/http/parse_json.h"
#include "server/http/validator.h"
#include "tests/server/fake_device.h"
#include "tests/server/fake_scene.h"

namespace raywalk::api {
namespace {

void expect_valid(const std::string& schema, const Json& json) {
  const http::Contract contract(http::embedded_contract());
  for (const auto& offence : contract.schema(schema).check(json)) ADD_FAILURE() << offence.pointer << offence.detail;
}

TEST(WireSpec, ComesBackAsItWas) {
  BenchmarkSpec spec;
  spec.scene = "a";
  spec.modes = {BenchMode::trace};
  spec.batch = 4;
  spec.techniques = {{"bvh", "while-while", {{"bins", 16.0}}, {{"registers", 40.0}, {"test", "moeller"}}},
                     {"bvh", "pair", {}, {}, Tier::automatic}};
  const Json json = to_json(spec);
  expect_valid("BenchmarkSpec", json);
  EXPECT_EQ(json.at("batch"), 4);
  EXPECT_EQ(json.at("techniques")[0].at("kernel").dump(), R"({"registers":40,"test":"moeller"})");
  EXPECT_FALSE(json.at("techniques")[1].contains("kernel"));
  EXPECT_EQ(json.at("techniques")[0].at("tier"), "strict");
  EXPECT_EQ(json.at("techniques")[1].at("tier"), "auto");
  EXPECT_EQ(parse_spec(json), spec);
}

TEST(WireKinds, ListTheOptionsOfKernels) {
  const test::FakeDevice device;
  const Json options = to_json(device.kinds()[0]).at("traversals")[0].at("options");
  ASSERT_EQ(options.size(), 3u);
  EXPECT_EQ(options[0].at("name"), "registers");
  EXPECT_EQ(options[0].at("maximum"), 255);
  EXPECT_FALSE(options[0].contains("step"));
  EXPECT_EQ(options[1].at("choices"), Json::array({"watertight", "moeller"}));
  EXPECT_EQ(options[2].at("step"), 32);
  for (const Json& option : options) expect_valid("Option", option);
}

class WireResult : public testing::Test {
 protected:
  WireResult() {
    result_.created_at = "2026-11-22T00:00:00Z";
    result_.machine = describe_machine("fake", {{"driver", "580"}}, 1);
    result_.scene = test::scene_named("a");
    row_.structure = "bvh";
    row_.traversal = "while-while";
    row_.structure_id = "a.bvh";
    row_.frame_ms.median = 2;
    row_.frame_ms.samples = 1;
    job_.id = "j1";
    BenchmarkSpec spec;
    spec.scene = "a";
    spec.techniques = {{"bvh", "while-while"}};
    spec.modes = {BenchMode::primary};
    job_.spec = spec;
  }
  Json json() {
    result_.rows = {row_};
    const Json json = to_json(result_, job_, device_.kinds());
    expect_valid("BenchmarkResult", json);
    return json;
  }

  test::FakeDevice device_;
  BenchmarkResult result_;
  ResultRow row_;
  Job job_;
};

TEST_F(WireResult, OfADeviceThatHasNeitherKernelsNorBatchesNorSensors) {
  const Json result = json();
  EXPECT_TRUE(result.at("telemetry").is_null());
  EXPECT_TRUE(result.at("rows")[0].at("kernel").is_null());
  EXPECT_TRUE(result.at("rows")[0].at("throughput").is_null());
}

TEST_F(WireResult, OfADeviceThatHasAll) {
  row_.kernel_options = {{"registers", 40}, {"test", 0}, {"block", 128}};
  row_.changed_options = " registers=40";
  row_.kernel = KernelFigures{.registers = 40, .occupancy = 0.75};
  row_.throughput = {16, row_.frame_ms, 5500};
  result_.telemetry.emplace();
  result_.telemetry->core_clock_mhz = {1500, 1700, 1900};
  const Json result = json(), row = result.at("rows")[0];
  EXPECT_EQ(row.at("kernel").at("options").dump(), R"({"block":128,"registers":40,"test":"watertight"})");
  EXPECT_EQ(row.at("kernel").at("occupancy"), 0.75);
  EXPECT_EQ(row.at("throughput").at("frames_per_launch"), 16);
  EXPECT_EQ(row.at("throughput").at("frame_ms").at("median"), 2.0);
  EXPECT_EQ(result.at("telemetry").at("core_clock_mhz").at("median"), 1700.0);
  EXPECT_EQ(result.at("machine").at("device_details").at("driver"), "580");
}

TEST_F(WireResult, CsvHasTheSameNumberOfFieldsInEveryLine) {
  row_.kernel = KernelFigures{.registers = 40};
  row_.changed_options = " registers=40";
  result_.rows = {ResultRow{}, row_};
  std::istringstream csv(to_csv(result_));
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 3u);
  for (const std::string& line : lines) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(lines[0].begin(), lines[0].end(), ',')) << line;
  }
  EXPECT_NE(lines[2].find(",registers=40,40,"), std::string::npos) << lines[2];
}

TEST(WireJob, OfAKernelThatTheCompilerRefusesTellsTheCause) {
  Job job;
  job.id = "j1";
  job.state = JobState::failed;
  job.error =
      std::make_exception_ptr(KernelRefused("The kernel does not compile.\nptxas error : too much shared data"));
  const Json error = error_json(job);
  EXPECT_EQ(error.at("code"), "kernel_refused");
  EXPECT_EQ(error.at("retryable"), false);
  EXPECT_NE(error.at("detail").get<std::string>().find("too much shared data"), std::string::npos);
}

TEST(Machine, DetailsOfTheDeviceMakeAnother) {
  const Machine a = describe_machine("gpu", {{"driver", "580"}}, 1),
                b = describe_machine("gpu", {{"driver", "590"}}, 1);
  EXPECT_NE(a.fingerprint, b.fingerprint);
  EXPECT_EQ(a.fingerprint, describe_machine("gpu", {{"driver", "580"}}, 1).fingerprint);
}

}  // namespace
}  // namespace raywalk::api
