// Problems, routing, negotiation and the guard.
#include <gtest/gtest.h>

#include "server/api/accept.h"
#include "server/device/device_queue.h"
#include "server/http/guard.h"
#include "server/http/problem.h"
#include "server/http/router.h"

namespace raywalk::http {
namespace {

Problem problem_of(const std::function<void()>& act) {
  try {
    act();
  } catch (...) {
    return problem_of_current_exception("r1");
  }
  return {};
}

TEST(Problem, OfARefusal) {
  const Problem p = problem_of([] {
    throw Refusal(Refusal::Why::unknown, "unknown_scene", "no such").at("/scene").known({"a", "b"});
  });
  const Json json = to_json(p, "/v1/x", "r1");
  EXPECT_EQ(json.at("status"), 404);
  EXPECT_EQ(json.at("code"), "unknown_scene");
  EXPECT_EQ(json.at("errors"), (Json::array({{{"pointer", "/scene"}, {"detail", "no such"}}})));
  EXPECT_EQ(json.at("known"), Json::array({"a", "b"}));
  EXPECT_EQ(json.at("retryable"), false);
  EXPECT_EQ(json.at("request_id"), "r1");
}

TEST(Problem, OfABusyDeviceMayBeTriedAgain) {
  const Problem p = problem_of([] { throw DeviceBusy("device_busy", "held"); });
  EXPECT_EQ(p.status, 503);
  EXPECT_EQ(to_json(p, "", "").at("retryable"), true);
  EXPECT_EQ(problem_response(p, "", "").headers.count("Retry-After"), 1u);
}

TEST(Problem, OfAFullDeviceHasBothFiguresAndIsNotTriedAgain) {
  const Problem p = problem_of([] { throw OutOfDeviceMemory(2000, 1000); });
  const Response response = problem_response(p, "/v1/frames", "r1");
  EXPECT_EQ(response.status, 503);
  EXPECT_FALSE(response.headers.contains("Retry-After"));
  const Json json = Json::parse(response.body);
  EXPECT_EQ(json.at("code"), "out_of_device_memory");
  EXPECT_EQ(json.at("needed_bytes"), 2000);
  EXPECT_EQ(json.at("free_bytes"), 1000);
  EXPECT_EQ(json.at("retryable"), false);
}

TEST(Problem, OfALostDeviceNamesTheCauseAndMayBeTriedAgain) {
  const Problem p = problem_of([] { throw DeviceLost("cuLaunchKernel: illegal address"); });
  const Json json = to_json(p, "/v1/frames", "r1");
  EXPECT_EQ(json.at("status"), 503);
  EXPECT_EQ(json.at("code"), "device_lost");
  EXPECT_EQ(json.at("retryable"), true);
  EXPECT_NE(json.at("detail").get<std::string>().find("illegal address"), std::string::npos);
  EXPECT_FALSE(json.contains("needed_bytes"));
}

TEST(Problem, OfARefusedKernelNamesTheFirstErrorOfTheLog) {
  const auto detail = [](const char* log) {
    const Problem p = problem_of([&] { throw KernelRefused(log); });
    EXPECT_EQ(p.status, 422);
    EXPECT_EQ(p.code, "kernel_refused");
    EXPECT_FALSE(p.retryable);
    return p.detail;
  };
  const std::string beginning = "The device's compiler refuses the kernel with these options: ";
  EXPECT_EQ(detail("It does not compile: NVRTC_ERROR_COMPILATION.\nptxas info : 0 bytes\nptxas error : too much shared "
                   "data\nptxas fatal : no errors"),
            beginning + "ptxas error : too much shared data");
  EXPECT_EQ(detail("It does not compile."), beginning + "It does not compile.");
}

TEST(Problem, HidesInternalCauses) {
  const Problem p = problem_of([] { throw std::runtime_error("/secret/path"); });
  EXPECT_EQ(p.status, 500);
  EXPECT_EQ(p.detail.find("secret"), std::string::npos);
  EXPECT_EQ(problem_of([] { throw std::bad_alloc(); }).status, 503);
  EXPECT_EQ(problem_of([] { throw 7; }).status, 500);
}

TEST(Problem, SurvivesBytesThatAreNoUtf8) {
  const Response r = problem_response({404, "x", "\xff\xfe"}, "/\xff", "r");
  EXPECT_NO_THROW(Json::parse(r.body));
}

Router router() {
  static const Contract kept(embedded_contract());
  std::vector<Route> routes;
  for (const Operation& o : kept.operations()) {
    routes.push_back({o.method, o.pattern, [](const Request&) { return Response{}; }});
  }
  return Router(kept, std::move(routes));
}

TEST(Router, FindsByMethodAndPath) {
  const Router r = router();
  const auto match = r.find("GET", "/v1/scenes/bunny/cameras");
  EXPECT_EQ(match.entry->operation->id, "list_cameras");
  EXPECT_EQ(match.in_path.at("scene"), "bunny");
  EXPECT_EQ(r.find("HEAD", "/livez").entry->operation->id, "get_livez");
}

TEST(Router, TellsMissingPathsFromWrongMethods) {
  const Router r = router();
  for (const char* path : {"/", "", "/v1", "/v1/scenes/", "/v1/scenes/a/b", "/livez/"}) {
    const Problem p = problem_of([&] { r.find("PATCH", path); });
    EXPECT_TRUE(p.status == 404 || p.status == 405) << path;
  }
  EXPECT_EQ(problem_of([&] { r.find("GET", "/v1/nothing"); }).status, 404);
  EXPECT_EQ(problem_of([&] { r.find("DELETE", "/livez"); }).status, 405);
  EXPECT_EQ(r.allowed_methods("/v1/scenes"), "GET, HEAD, POST");
}

TEST(Router, RoutesAndContractAreOneToOne) {
  const Contract contract(embedded_contract());
  EXPECT_THROW(Router(contract, {}), std::logic_error);
}

TEST(Guard, AnswersLoopbackNamesAndTheBoundAddressOnly) {
  const Guard guard("127.0.0.5");
  for (const char* host : {"localhost", "LOCALHOST:80", "127.0.0.1:7979", "[::1]:7979", "[::1]", "127.0.0.5:1"}) {
    EXPECT_TRUE(guard.host_allowed(host)) << host;
  }
  for (const char* host :
       {"", "example.com", "localhost.example.com", "127.0.0.1.example.com", "127.0.0.1:8x", ":80"}) {
    EXPECT_FALSE(guard.host_allowed(host)) << host;
  }
  EXPECT_TRUE(guard.origin_allowed("http://localhost:5173"));
  for (const char* origin : {"null", "http://example.com", "file://", "localhost"}) {
    EXPECT_FALSE(guard.origin_allowed(origin)) << origin;
  }
}

TEST(Guard, FindsControlCharacters) {
  EXPECT_FALSE(has_control_characters("plain\ttext \xc3\xa9"));
  EXPECT_TRUE(has_control_characters("a\r\nb"));
  EXPECT_TRUE(has_control_characters(std::string_view("a\0b", 3)));
}

TEST(Accept, PicksTheBestOffer) {
  const std::vector<std::string> offers = {"image/jpeg", "image/png", "application/octet-stream"};
  const auto pick = [&](const char* accept) { return api::negotiate(accept, offers).value_or("none"); };
  EXPECT_EQ(pick(""), "image/jpeg");
  EXPECT_EQ(pick("*/*"), "image/jpeg");
  EXPECT_EQ(pick("image/*;q=0.5, application/octet-stream"), "application/octet-stream");
  EXPECT_EQ(pick("image/jpeg;q=0.2, */*;q=0.4"), "image/png");
  EXPECT_EQ(pick("IMAGE/PNG ; q=1"), "image/png");
  EXPECT_EQ(pick("text/html"), "none");
  EXPECT_EQ(pick("image/jpeg;q=0, image/webp"), "none");
}

}  // namespace
}  // namespace raywalk::http
