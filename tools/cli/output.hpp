#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "io/new_file.hpp"

namespace quadrille {

/// Writes JSON objects, one a line, to a file, which appears once it is whole, or, for "-", to
/// stdout.
class JsonLines {
 public:
  /// An empty path writes nothing.
  /// @throws io::FileError if the file cannot be created
  explicit JsonLines(const std::string& path);

  /// True if stdout belongs to the JSON.
  bool owns_stdout() const { return path_ == "-"; }

  /// @throws io::FileError if the line cannot be written
  void write(const io::Json& json);

  /// Puts the file in its place; without this call nothing is left behind.
  /// @throws io::FileError if that fails
  void finish();

 private:
  std::string path_;
  std::optional<io::NewFile> new_file_;
  std::ofstream file_;
};

/// The path for the picture of one input: as given if it is the only one, else with the input's
/// stem (and, for later clouds of the same input, a number) before the extension.
class PicturePaths {
 public:
  PicturePaths(std::string path, bool several) : path_(std::move(path)), several_(several) {}

  /// True if pictures are wanted.
  bool wanted() const { return !path_.empty(); }
  std::string next(const std::string& input);

 private:
  std::string path_;
  bool several_;
  std::vector<std::string> used_;
};

/// Writes each warning as one line to stderr.
void print_warnings(const std::string& input, const std::vector<std::string>& warnings);

/// Appends warnings about something that is not the input itself, named before each: "FILE: …".
void add_warnings(const std::string& about, const std::vector<std::string>& warnings,
                  std::vector<std::string>* all);

/// Writes to stdout and sees to it that it arrived.
/// @throws std::runtime_error if it did not
void print(const std::string& text);

}  // namespace quadrille
