#include "process/runtime/file_claim.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "io/file_bytes.hpp"

namespace quadrille {
namespace {

bool is_regular(const std::string& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode);
}

/// Returns whether the name still refers to the open file.
bool has_name(int fd, const std::string& path) {
  struct stat open = {}, named = {};
  return fstat(fd, &open) == 0 && stat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

}  // namespace

FileClaim::~FileClaim() {
  if (fd_ >= 0) close(fd_);
}

FileClaim FileClaim::of_target(const std::string& path) {
  if (!is_regular(path)) return {};
  for (;;) {
    const int fd = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (fd < 0) {
      throw io::FileError(path, "",
                          fmt::format("cannot be written ({}); check the folder and its "
                                      "permissions",
                                      std::strerror(errno)));
    }
    FileClaim claim(fd);
    if (flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      throw io::FileError(path, "", "is written by another process; give each a file of its own");
    }
    // The file may have been replaced by its holder in the meantime.
    if (has_name(fd, path)) return claim;
  }
}

FileClaim FileClaim::of_file(const std::string& path) {
  if (!is_regular(path)) return {};
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  // On a file system without locks, the file is used without a claim.
  if (fd >= 0) flock(fd, LOCK_EX | LOCK_NB);
  return FileClaim(fd);
}

}  // namespace quadrille
