// Offences have the pointers that programs rely on; defaults come from the schema.
#include <gtest/gtest.h>

#include <set>

#include "server/http/contract.h"
#include "server/http/parse_json.h"
#include "server/http/problem.h"

namespace raywalk::http {
namespace {

const Contract& contract() {
  static const Contract value(embedded_contract());
  return value;
}

std::set<std::string> pointers(const std::string& schema, const std::string& text) {
  std::set<std::string> out;
  for (const auto& offence : contract().schema(schema).check(parse_json(text))) out.insert(offence.pointer);
  return out;
}

const std::string kFrame = R"("scene": "s", "structure": "bvh", "traversal": "x")";

using Pointers = std::set<std::string>;

TEST(Validator, AcceptsAMinimalFrameAndFillsDefaults) {
  Json frame = parse_json("{" + kFrame + R"(, "camera": {"eye": [0, 0, 1], "target": [0, 0, 0]}})");
  const Validator validator = contract().schema("FrameRequest");
  EXPECT_TRUE(validator.check(frame).empty());
  validator.fill_defaults(frame);
  EXPECT_EQ(frame.at("width"), 512);
  EXPECT_EQ(frame.at("output"), "color");
  EXPECT_EQ(frame.at("camera").at("vertical_fov_deg"), 45);
  EXPECT_FALSE(frame.contains("mode"));
}

TEST(Validator, DefaultsFollowTheAlternativeThatIsMeant) {
  Json frame = parse_json("{" + kFrame + R"(, "camera": {"frame": 3}})");
  const Validator validator = contract().schema("FrameRequest");
  ASSERT_TRUE(validator.check(frame).empty());
  validator.fill_defaults(frame);
  EXPECT_EQ(frame.at("camera"), parse_json(R"({"frame": 3, "of": 400})"));
}

TEST(Validator, DefaultsReachNestedObjects) {
  Json job = parse_json(R"({"kind": "benchmark", "spec": {"scene": "s"}})");
  contract().schema("JobRequest").fill_defaults(job);
  EXPECT_EQ(job.at("spec").at("modes"), parse_json(R"(["primary", "shadow", "whitted"])"));
  EXPECT_EQ(job.at("spec").at("frames"), 400);
}

TEST(Validator, PointsAtEachOffence) {
  EXPECT_EQ(pointers("FrameRequest", "{" + kFrame + R"(, "width": "a", "height": 0, "x/y~z": 1})"),
            (Pointers{"/width", "/height", "/x~1y~0z"}));
  EXPECT_EQ(pointers("FrameRequest", "{}"), Pointers{""});
  EXPECT_EQ(pointers("FrameRequest", "[]"), Pointers{""});
  EXPECT_EQ(pointers("FrameRequest", "{" + kFrame + R"(, "camera": {"eye": [0, 0, "x"], "target": [0, 0]}})"),
            (Pointers{"/camera/eye/2", "/camera/target"}));
  EXPECT_EQ(pointers("FrameRequest", "{" + kFrame + R"(, "camera": {"frame": -1, "from": 3}})"),
            (Pointers{"/camera/frame", "/camera/from"}));
  EXPECT_EQ(pointers("FrameRequest", "{" + kFrame + R"(, "camera": 7})"), Pointers{"/camera"});
  EXPECT_EQ(pointers("JobRequest", R"({"kind": "benchmark", "spec": {"scene": "s", "modes": ["trace", "no"]}})"),
            Pointers{"/spec/modes/1"});
  EXPECT_EQ(pointers("StructureRequest", R"({"scene": "s", "kind": "k", "options": {"a": [1]}})"),
            Pointers{"/options/a"});
}

TEST(Validator, SaysWhatWasExpectedAndWhatWasGot) {
  const auto why = [](const std::string& schema, const std::string& text) {
    const auto offences = contract().schema(schema).check(parse_json(text));
    return offences.size() == 1 ? offences[0].detail : "(" + std::to_string(offences.size()) + " offences)";
  };
  const auto frame = [&](const std::string& more) { return why("FrameRequest", "{" + kFrame + ", " + more + "}"); };
  EXPECT_EQ(frame(R"("width": 9000)"), "must be at most 8192; it is 9000");
  EXPECT_EQ(frame(R"("width": 0)"), "must be at least 1; it is 0");
  EXPECT_EQ(frame(R"("width": 1.5)"), "must be an integer; it is 1.5");
  EXPECT_EQ(frame(R"("width": "9")"), R"(must be an integer; it is "9")");
  EXPECT_EQ(frame(R"("mode": "trace")"), R"(must be one of primary, shadow, whitted; it is "trace")");
  EXPECT_EQ(frame(R"("camera": {"eye": [0, 0], "target": [0, 0, 1]})"), "must have 3 items; it is a list of 2");
  EXPECT_EQ(frame(R"("camera": {"eye": [0, 0, 1e31], "target": [0, 0, 1]})"), "must be at most 1e30; it is 1e31");
  EXPECT_EQ(frame(R"("camera": {"eye": [0, 0, 1]})"), "must have the field 'target'");
  EXPECT_EQ(why("PathFrame", R"({"frame": 1, "x": 1})"), "there is no field 'x'; the fields are frame, of");
  EXPECT_EQ(why("StructureRequest", R"({"scene": "S", "kind": "k"})"),
            R"(must match ^[a-z0-9][a-z0-9_-]{0,63}$; it is "S")");
  EXPECT_EQ(why("StructureRequest", R"({"scene": "s", "kind": "k", "options": {"a": [1]}})"),
            "must be a number or a text; it is a list of 1");
  EXPECT_EQ(why("BenchmarkSpec", R"({"scene": "s", "modes": []})"), "must have at least 1 item; it is a list of 0");
  EXPECT_EQ(why("BenchmarkSpec", R"({"scene": "s", "modes": ["trace", "trace"]})"), R"(must not hold "trace" twice)");
}

TEST(Validator, WholeNumbersAreIntegersHoweverWritten) {
  for (const char* width : {"512", "512.0", "5.12e2"}) {
    EXPECT_EQ(pointers("FrameRequest", "{" + kFrame + ", \"width\": " + width + "}"), Pointers{}) << width;
  }
  EXPECT_EQ(pointers("FrameRequest", "{" + kFrame + ", \"width\": 512.5}"), Pointers{"/width"});
  EXPECT_EQ(pointers("FrameRequest", "{" + kFrame + ", \"width\": 1e300}"), Pointers{"/width"});
  EXPECT_EQ(pointers("FrameRequest", "{" + kFrame + ", \"width\": 18446744073709551615}"), Pointers{"/width"});
}

TEST(ParseJson, RefusesWhatIsNotJson) {
  for (const std::string& text : {std::string(), std::string("{"), std::string("NaN"), std::string("1e999"),
                                  std::string("\"\xff\""), std::string(100'000, '[')}) {
    EXPECT_THROW(parse_json(text), ApiError) << text.substr(0, 20);
  }
}

std::string refusal_of(const std::string& text) {
  try {
    parse_json(text);
  } catch (const ApiError& e) {
    return e.offences().empty() ? e.what() : e.code() + " " + e.offences()[0].pointer;
  }
  return "";
}

TEST(ParseJson, SaysWhereItStopped) {
  EXPECT_EQ(refusal_of(R"({"a": x})"), "The body is not JSON at byte 7: unexpected 'x'.");
  EXPECT_EQ(refusal_of(R"({"a": 1)"), "The body is not JSON at byte 8: it ends too early.");
  EXPECT_EQ(refusal_of("\"\xff\""), "The body is not JSON at byte 2: not UTF-8.");
  EXPECT_EQ(refusal_of(""), "The body is empty; JSON is expected.");
}

TEST(ParseJson, RefusesFieldsThatComeTwice) {
  EXPECT_EQ(refusal_of(R"({"a": 1, "b": 2, "a": 1})"), "duplicate_field /a");
  EXPECT_EQ(refusal_of(R"({"s": {"t": [{"x": 1}, [], {"x": 1, "a/b": {}, "a/b": 2}]}})"),
            "duplicate_field /s/t/2/a~1b");
  EXPECT_EQ(refusal_of(R"({"a": {"a": [{"a": 1}, {"a": 1}]}, "b": {"a": 1}})"), "");
}

TEST(Contract, ParametersAreTypedAndChecked) {
  for (const Operation& operation : contract().operations()) {
    if (operation.id != "list_cameras") continue;
    EXPECT_EQ(check_query(operation, {}).at("frames"), 400);
    EXPECT_EQ(check_query(operation, {{"frames", "7"}}).at("frames"), 7);
    for (const char* bad : {"0", "x", "", "1.5", "nan", "1e400"}) {
      EXPECT_THROW(check_query(operation, {{"frames", bad}}), ApiError) << bad;
    }
    EXPECT_THROW(check_query(operation, {{"frame", "1"}}), ApiError);
    EXPECT_THROW(check_path(operation, {{"scene", "Bad Name"}}), ApiError);
    return;
  }
  FAIL() << "no list_cameras";
}

}  // namespace
}  // namespace raywalk::http
