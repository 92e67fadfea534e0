// Named things that statements refer to, one of them current: MGF's colours, materials and vertices.
#pragma once
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>

#include "server/scene/text.h"

namespace raywalk {

template <class T>
class MgfContexts {
 public:
  explicit MgfContexts(const char* what) : what_(what) {}
  MgfContexts(const MgfContexts&) = delete;  // current_ may point inside
  MgfContexts& operator=(const MgfContexts&) = delete;

  T& current() { return *current_; }
  /// Throws std::runtime_error if there is none. Names must outlive this object.
  T& named(std::string_view name) {
    const auto found = named_.find(name);
    if (found == named_.end()) {
      throw std::runtime_error(std::string(what_) + " " + in_quotes(name) + " is not defined");
    }
    return found->second;
  }

  /// The arguments of the statement: none for a fresh one without a name; a name for the one so called; a name and
  /// "=" for a fresh one of that name, like another one whose name follows.
  void select(std::span<const std::string_view> arguments) {
    if (arguments.empty()) {
      unnamed_ = T{};
      current_ = &unnamed_;
    } else if (arguments.size() == 1) {
      current_ = &named(arguments[0]);
    } else {
      if (arguments[1] != "=") throw std::runtime_error("'=' is missing behind the name");
      const T fresh = arguments.size() > 2 ? named(arguments[2]) : T{};
      if (named_.size() == kMost) throw std::runtime_error(std::string("too many names of the kind: ") + what_);
      current_ = &(named_[arguments[0]] = fresh);
    }
  }

 private:
  static constexpr size_t kMost = 10'000'000;

  const char* what_;
  std::unordered_map<std::string_view, T> named_;
  T unnamed_{};
  T* current_ = &unnamed_;
};

}  // namespace raywalk
