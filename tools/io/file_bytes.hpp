#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::io {

/// A file that cannot be used: one line that names the file, the place in it and the cure.
class FileError : public std::runtime_error {
 public:
  /// @param path   the file
  /// @param where  "byte 120", "line 3", a field, or empty
  /// @param what   what is wrong, and how to mend it
  FileError(const std::string& path, const std::string& where, const std::string& what);
};

/// The whole content of a regular file.
/// @throws FileError if it is missing, is no regular file, or cannot be read
std::vector<std::byte> read_file(const std::string& path);

/// All that comes on the standard input.
/// @throws FileError if that is more than 2 GiB
std::vector<std::byte> read_standard_input();

}  // namespace quadrille::io
