#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lab/experiments/plot.hpp"

namespace quadrille {

/// The files that a command writes into a folder when its work is done.
class OutputFolder {
 public:
  /// Makes the folder and checks that the files can be made in it, before any work is done.
  /// @param folder  value of option --out
  /// @param names  names of the files
  /// @throws io::FileError if that fails
  OutputFolder(const std::string& folder, const std::vector<std::string>& names);

  /// Writes a file. It appears, or replaces the previous one, only once it is complete.
  /// @throws io::FileError if that fails
  void write(const std::string& name, const std::string& text);

  /// Draws plots, as draw_plots() does.
  void draw(const std::string& name, const std::vector<experiments::Plot>& plots);

  /// Returns the paths of the written files, for the user to read.
  std::string list() const;

 private:
  std::string path_of(const std::string& name) const;

  std::string folder_;
  std::vector<std::string> written_;
};

/// Draws plots with gnuplot, and leaves the script beside the picture. Says so on stderr if there
/// is no gnuplot.
/// @param path  path of the picture, which ends in .svg
/// @return that path, or the script's if there is no picture
/// @throws io::FileError if a file cannot be written
std::string draw_plots(const std::string& path, const std::vector<experiments::Plot>& plots);

}  // namespace quadrille
