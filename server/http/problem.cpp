// Exceptions to problem+json.
#include "server/http/problem.h"

#include <spdlog/spdlog.h>

#include <new>
#include <sstream>

#include "server/device/device_queue.h"

namespace raywalk::http {
namespace {

/// The line of the compiler's log that names the cause: the first with an error, else the first of all.
std::string cause_of(const KernelRefused& refused) {
  std::istringstream log(refused.what());
  std::string first, line;
  std::getline(log, first);
  while (std::getline(log, line)) {
    if (line.find("error") != std::string::npos) return line;
  }
  return first;
}

}  // namespace

int status_of(Refusal::Why why) {
  switch (why) {
    case Refusal::Why::malformed:
      return 400;
    case Refusal::Why::unknown:
      return 404;
    case Refusal::Why::conflict:
      return 409;
    case Refusal::Why::invalid:
      return 422;
    case Refusal::Why::too_many:
      return 429;
    case Refusal::Why::unavailable:
      return 503;
  }
  return 500;
}

const char* reason_phrase(int status) {
  switch (status) {
    case 400:
      return "Bad Request";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 406:
      return "Not Acceptable";
    case 409:
      return "Conflict";
    case 413:
      return "Content Too Large";
    case 414:
      return "URI Too Long";
    case 415:
      return "Unsupported Media Type";
    case 416:
      return "Range Not Satisfiable";
    case 422:
      return "Unprocessable Content";
    case 429:
      return "Too Many Requests";
    case 503:
      return "Service Unavailable";
    default:
      return status < 500 ? "Request Refused" : "Internal Server Error";
  }
}

Json to_json(const Problem& problem, const std::string& instance, const std::string& request_id) {
  Json errors = Json::array();
  for (const Refusal::Offence& o : problem.offences) errors.push_back({{"pointer", o.pointer}, {"detail", o.detail}});
  Json body = {{"type", std::string("about:blank#").append(problem.code)},
               {"title", reason_phrase(problem.status)},
               {"status", problem.status},
               {"detail", problem.detail},
               {"instance", instance},
               {"code", problem.code},
               {"errors", std::move(errors)},
               {"retryable", problem.retryable},
               {"request_id", request_id}};
  if (!problem.known.empty()) body["known"] = problem.known;
  if (problem.needed_bytes) body["needed_bytes"] = *problem.needed_bytes;
  if (problem.free_bytes) body["free_bytes"] = *problem.free_bytes;
  return body;
}

Response problem_response(const Problem& problem, const std::string& instance, const std::string& request_id) {
  Response response = json_response(to_json(problem, instance, request_id), problem.status);
  response.content_type = "application/problem+json";
  if (problem.retryable && (problem.status == 429 || problem.status == 503)) response.headers["Retry-After"] = "1";
  return response;
}

Problem problem_of_current_exception(const std::string& request_id) {
  try {
    throw;
  } catch (const ApiError& e) {
    return {e.status(), e.code(), e.what(), e.offences()};
  } catch (const Refusal& e) {
    return {status_of(e.why()), e.code(), e.what(), e.offences(), e.known_names(), e.is_retryable()};
  } catch (const DeviceBusy& e) {
    return {503, e.code(), e.what()};
  } catch (const OutOfDeviceMemory& e) {
    Problem problem{503, "out_of_device_memory", e.what(), {}, {}, false};
    if (e.needed_bytes() > 0) problem.needed_bytes = e.needed_bytes();  // 0: not known
    problem.free_bytes = e.free_bytes();
    return problem;
  } catch (const DeviceLost& e) {
    return {503, "device_lost", std::string("The device is lost, and the daemon ends: ") + e.what()};
  } catch (const KernelRefused& e) {
    spdlog::warn("request={} needs a kernel that the compiler refuses: {}", request_id, e.what());
    return {422, "kernel_refused", "The device's compiler refuses the kernel with these options: " + cause_of(e)};
  } catch (const std::bad_alloc&) {
    return {503, "out_of_memory", "The daemon has not enough memory for this."};
  } catch (const std::exception& e) {
    spdlog::error("request={} failed: {}", request_id, e.what());
  } catch (...) {
    spdlog::error("request={} failed with an exception of unknown type", request_id);
  }
  return {500, "internal_error", "Something went wrong in the daemon; its log has the cause under this request id."};
}

}  // namespace raywalk::http
