#pragma once

#include <string>
#include <utility>

namespace quadrille {

/// The right of one process to a file: a lock that ends with the process, however that ends.
class FileClaim {
 public:
  FileClaim() = default;
  FileClaim(FileClaim&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileClaim& operator=(FileClaim&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~FileClaim();

  /// Claims the file that has a name, which is made if it is missing. Its holder may replace it by
  /// another that it has claimed. What is no regular file needs no claim.
  /// @throws io::FileError if it cannot be written, or another process holds it
  static FileClaim of_target(const std::string& path);

  /// Claims a file of this process's own.
  static FileClaim of_file(const std::string& path);

 private:
  explicit FileClaim(int fd) : fd_(fd) {}

  int fd_ = -1;
};

}  // namespace quadrille
