// RFC 9457 problem details: every error answer has this one shape.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "kernels/platform.h"
#include "server/http/message.h"
#include "server/system/refusal.h"

namespace raywalk::http {

/// An error that HTTP itself names, such as 405; domain errors are Refusals.
class ApiError : public std::runtime_error {
 public:
  ApiError(int status, std::string code, const std::string& detail, std::vector<Refusal::Offence> offences = {})
      : std::runtime_error(detail), status_(status), code_(std::move(code)), offences_(std::move(offences)) {}
  int status() const { return status_; }
  const std::string& code() const { return code_; }
  const std::vector<Refusal::Offence>& offences() const { return offences_; }

 private:
  int status_;
  std::string code_;
  std::vector<Refusal::Offence> offences_;
};

struct Problem {
  int status = 500;
  std::string code = "internal_error";
  std::string detail;
  std::vector<Refusal::Offence> offences = {};
  std::vector<std::string> known = {};
  bool retryable = status == 429 || status == 503;
  std::optional<u64> needed_bytes = {}, free_bytes = {};  // of out_of_device_memory
};

int status_of(Refusal::Why why);
/// "Not Found" and the like.
const char* reason_phrase(int status);

/// As it travels; also the `error` of a failed job.
Json to_json(const Problem& problem, const std::string& instance, const std::string& request_id);
Response problem_response(const Problem& problem, const std::string& instance, const std::string& request_id);

/// The problem of the exception in flight. One that is neither ApiError nor Refusal is logged with the request's id,
/// and its text is not shown to the caller.
Problem problem_of_current_exception(const std::string& request_id);

}  // namespace raywalk::http
