// A parent that starts the daemon again when it crashes.
#pragma once
#include <string>
#include <vector>

namespace raywalk {

/// Runs this program once more, with its arguments but not as a supervisor, as a child and waits for it. SIGTERM and
/// SIGINT, which must be blocked, are handed on. A child that crashes (a signal, or an exit code that names no setting)
/// is started again on the same port and without --fault-after, at first quickly, then slower. `arguments` are those of
/// main, `host` and `port` what they say. The value is the exit code of a child that ended by itself. Throws
/// http::PortInUse, and std::runtime_error after too many crashes.
int supervise(const std::vector<std::string>& arguments, const std::string& host, int port);

}  // namespace raywalk
