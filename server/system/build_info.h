// Facts about this build, filled in by CMake.
#pragma once
#include <map>
#include <string>

namespace raywalk::build_info {

extern const char* const kCompiler;
extern const char* const kBuildType;
extern const char* const kFlags;
extern const char* const kVersion;
extern const char* const kGitCommit;
extern const char* const kScenesDir;  // of the source tree

/// Libraries that the daemon was built with: name to version.
std::map<std::string, std::string> libraries();

}  // namespace raywalk::build_info
