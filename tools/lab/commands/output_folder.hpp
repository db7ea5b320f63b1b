#pragma once

#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// The files that a command writes into a folder once its work is done.
class OutputFolder {
 public:
  /// Makes the folder and sees to it that the files can be made there, before any work.
  /// @param folder  of option --out
  /// @param names   of the files
  /// @throws io::FileError if that fails
  OutputFolder(const std::string& folder, const std::vector<std::string>& names);

  /// Writes a file, which appears, or replaces the one before, once it is whole.
  /// @throws io::FileError if that fails
  void write(const std::string& name, const std::string& text);

  /// The paths of the files that were written, for the user to read.
  std::string list() const;

 private:
  std::string path_of(const std::string& name) const;

  std::string folder_;
  std::vector<std::string> written_;
};

}  // namespace quadrille
