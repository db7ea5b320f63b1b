#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace quadrille::io {

/// A file that appears only once it is whole: it is written under a name of its own beside the
/// target, which stays as it is until commit(). What is no regular file, such as a pipe or
/// /dev/stdout, is written to directly.
class NewFile {
 public:
  /// Makes the file to write to.
  /// @throws FileError naming the target if it cannot be created
  explicit NewFile(const std::string& target);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  /// Removes what was not committed.
  ~NewFile();

  /// Where to write.
  const std::string& path() const { return path_; }

  /// Writes all that the file is to hold.
  /// @throws FileError naming the target if that fails
  void write(std::span<const std::byte> bytes);
  void write(const std::string& text) { write(std::as_bytes(std::span(text))); }

  /// Puts what was written, flushed or closed before, in the target's place.
  /// @throws FileError naming the target if that fails
  void commit();

 private:
  std::string target_, path_;
  bool committed_ = false;
};

/// Makes a file, or replaces the content of one, by a NewFile.
/// @throws FileError if it cannot be written; what was there is then as it was
void write_file(const std::string& path, std::span<const std::byte> bytes);

/// As above, for text.
void write_file(const std::string& path, const std::string& text);

}  // namespace quadrille::io
