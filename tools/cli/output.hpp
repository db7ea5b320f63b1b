#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.hpp"
#include "io/new_file.hpp"

namespace quadrille {

/// Writes JSON objects, one per line, to a file that appears once it is complete, or, for "-", to
/// stdout.
class JsonLines {
 public:
  /// With an empty path, nothing is written.
  /// @throws io::FileError if the file cannot be created
  explicit JsonLines(const std::string& path);

  /// Returns true if stdout is reserved for the JSON.
  bool owns_stdout() const { return path_ == "-"; }

  /// @throws io::FileError if the line cannot be written
  void write(const io::Json& json);

  /// Puts the file in place; without this call no file is left behind.
  /// @throws io::FileError if that fails
  void finish();

 private:
  std::string path_;
  std::optional<io::NewFile> new_file_;
  std::ofstream file_;
};

/// Chooses the path for the picture of each input: the given one if there is only one input,
/// otherwise with the input's stem (and, for further clouds of the same input, a number) before the
/// extension.
class PicturePaths {
 public:
  PicturePaths(std::string path, bool several) : path_(std::move(path)), several_(several) {}

  /// Returns true if pictures are wanted.
  bool wanted() const { return !path_.empty(); }
  std::string next(const std::string& input);

 private:
  std::string path_;
  bool several_;
  std::vector<std::string> used_;
};

/// Writes each warning as one line to stderr.
void print_warnings(const std::string& input, const std::vector<std::string>& warnings);

/// Appends warnings about something other than the input itself, each preceded by its name: "FILE:
/// …".
void add_warnings(const std::string& about, const std::vector<std::string>& warnings,
                  std::vector<std::string>* all);

/// Writes to stdout and checks that the text was accepted.
/// @throws std::runtime_error if it was not
void print(const std::string& text);

}  // namespace quadrille
