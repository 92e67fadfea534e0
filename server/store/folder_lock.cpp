// flock on a file that stays where it is: removing it would let two daemons lock two files of that name.
#include "server/store/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace raywalk::store {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
  if (descriptor_ < 0) {
    throw FolderError("The state folder " + folder.string() + " cannot be locked: " + std::strerror(errno) + ".");
  }
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int error = errno;
  close(descriptor_);
  if (error == EWOULDBLOCK) {
    throw FolderError("Another daemon uses the state folder " + folder.string() +
                      "; stop it, or name another folder with --state.");
  }
  throw FolderError("The state folder " + folder.string() + " cannot be locked: " + std::strerror(error) + ".");
}

FolderLock::~FolderLock() {
  close(descriptor_);
}

}  // namespace raywalk::store
