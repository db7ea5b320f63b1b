#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::io {

/// A file that cannot be used. The message is one line with the file, the place in it and the
/// remedy.
class FileError : public std::runtime_error {
 public:
  /// @param path   the file
  /// @param where  "byte 120", "line 3", a field, or empty
  /// @param what  what is wrong, and how to fix it
  FileError(const std::string& path, const std::string& where, const std::string& what);
};

/// Returns the whole content of a regular file.
/// @throws FileError if it is missing, is not a regular file, or cannot be read
std::vector<std::byte> read_file(const std::string& path);

/// Reads the standard input to its end.
/// @throws FileError if it holds more than 2 GiB
std::vector<std::byte> read_standard_input();

}  // namespace quadrille::io
