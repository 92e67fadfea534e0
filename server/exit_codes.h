// Exit codes of the daemon.
#pragma once

namespace raywalk {

enum ExitCode { kDone = 0, kFailed = 1, kBadSetting = 2, kNoDevice = 3, kPortInUse = 4, kDeviceLost = 5 };

}  // namespace raywalk
