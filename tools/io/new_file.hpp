#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace quadrille::io {

/// A file that appears only once it is complete. It is written under a temporary name beside the
/// target, which stays unchanged until commit(). A target that is not a regular file, such as a
/// pipe or /dev/stdout, is written directly.
class NewFile {
 public:
  /// Creates the temporary file.
  /// @throws FileError naming the target if it cannot be created
  explicit NewFile(const std::string& target);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  /// Removes the temporary file if it was not committed.
  ~NewFile();

  /// Path of the file to write.
  const std::string& path() const { return path_; }

  /// Writes the whole content of the file.
  /// @throws FileError naming the target if that fails
  void write(std::span<const std::byte> bytes);
  void write(const std::string& text) { write(std::as_bytes(std::span(text))); }

  /// Replaces the target by what was written, which must be flushed or closed before.
  /// @throws FileError naming the target if that fails
  void commit();

 private:
  std::string target_, path_;
  bool committed_ = false;
};

/// Makes a file, or replaces the content of one, by means of a NewFile.
/// @throws FileError if it cannot be written; an existing file is then unchanged
void write_file(const std::string& path, std::span<const std::byte> bytes);

/// Like the above, for text.
void write_file(const std::string& path, const std::string& text);

}  // namespace quadrille::io
