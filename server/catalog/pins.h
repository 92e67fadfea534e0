// Scenes and structures that people asked to keep: they are not evicted until they are unpinned.
#pragma once
#include <mutex>
#include <set>
#include <string>

#include "server/system/refusal.h"

namespace raywalk {

/// Names of scenes and ids of structures, which hold a dot. From any thread; gone with the daemon.
class Pins {
 public:
  void add(const std::string& name) {
    const std::lock_guard lock(mutex_);
    names_.insert(name);
  }
  void remove(const std::string& name) {
    const std::lock_guard lock(mutex_);
    names_.erase(name);
  }
  bool has(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    return names_.contains(name);
  }
  /// Throws Refusal pinned when `name`, or a structure of the scene of that name, is pinned.
  void refuse(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    auto found = names_.find(name);
    if (found == names_.end()) {
      found = names_.lower_bound(name + ".");
      if (found == names_.end() || !found->starts_with(name + ".")) return;
    }
    throw Refusal(Refusal::Why::conflict, "pinned", "'" + *found + "' is pinned; unpin it first.");
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::string> names_;
};

}  // namespace raywalk
