#pragma once

#include <string>
#include <utility>

namespace quadrille {

/// The exclusive right of one process to a file: a lock that ends with the process, however that
/// ends.
class FileClaim {
 public:
  FileClaim() = default;
  FileClaim(FileClaim&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileClaim& operator=(FileClaim&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~FileClaim();

  /// Claims the file with this name, which is created if it is missing. The holder may replace it
  /// by another file that it has claimed. A path that is not a regular file needs no claim.
  /// @throws io::FileError if the file cannot be written, or another process holds it
  static FileClaim of_target(const std::string& path);

  /// Claims a file that belongs to this process.
  static FileClaim of_file(const std::string& path);

 private:
  explicit FileClaim(int fd) : fd_(fd) {}

  int fd_ = -1;
};

}  // namespace quadrille
