// Environment variables that last as long as one test.
#pragma once
#include <cstdlib>
#include <optional>
#include <string>

namespace raywalk::test {

/// Sets a variable; gives it back its earlier value when it goes.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* earlier = std::getenv(name)) earlier_ = earlier;
    ::setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (earlier_) {
      ::setenv(name_, earlier_->c_str(), 1);
    } else {
      ::unsetenv(name_);
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> earlier_;
};

}  // namespace raywalk::test
