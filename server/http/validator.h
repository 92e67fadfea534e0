// Checks a JSON value against one schema of the contract, and fills in the schema's defaults.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "server/http/message.h"
#include "server/system/refusal.h"

namespace raywalk::http {

class Validator {
 public:
  /// `schema` may refer to `#/components/...` of `document`. Throws std::runtime_error for a schema that is not one.
  Validator(const Json& document, const Json& schema);
  ~Validator();
  Validator(Validator&&) noexcept;
  Validator& operator=(Validator&&) noexcept;

  /// Every offence with its JSON pointer, at most 32; none when the value is valid. A missing field is an offence of
  /// the object that lacks it.
  std::vector<Refusal::Offence> check(const Json& value) const;

  /// Adds the default of every absent property that has one, at any depth. `value` is valid.
  void fill_defaults(Json& value) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace raywalk::http
