// A request that cannot be met, in the domain's words; the HTTP layer answers it as problem+json.
#pragma once
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace raywalk {

class Refusal : public std::runtime_error {
 public:
  enum class Why {
    malformed,    // cannot be read at all
    unknown,      // no such thing
    conflict,     // the thing is in another state
    invalid,      // readable, but its values make no sense
    too_many,     // the caller should wait
    unavailable,  // the service should be asked again later
  };

  /// One offence: a JSON pointer into the request body, or `?name` of a parameter, and what is wrong there.
  struct Offence {
    std::string pointer;
    std::string detail;
  };

  /// `code` is a stable word for programs such as unknown_scene.
  Refusal(Why why, std::string code, const std::string& detail)
      : std::runtime_error(detail), why_(why), code_(std::move(code)) {}

  Refusal& at(std::string pointer, std::string detail) {
    offences_.push_back({std::move(pointer), std::move(detail)});
    return *this;
  }
  /// At `pointer`, with the detail of the refusal itself.
  Refusal& at(std::string pointer) { return at(std::move(pointer), what()); }
  /// The same request may succeed later, though its kind of refusal does not say so.
  Refusal& retryable() {
    is_retryable_ = true;
    return *this;
  }
  Refusal& known(std::vector<std::string> names) {
    known_ = std::move(names);
    return *this;
  }

  Why why() const { return why_; }
  const std::string& code() const { return code_; }
  const std::vector<Offence>& offences() const { return offences_; }
  const std::vector<std::string>& known_names() const { return known_; }
  bool is_retryable() const { return is_retryable_ || why_ == Why::too_many || why_ == Why::unavailable; }

 private:
  Why why_;
  std::string code_;
  std::vector<Offence> offences_;
  std::vector<std::string> known_;
  bool is_retryable_ = false;
};

}  // namespace raywalk
