#pragma once

#include <string>
#include <vector>

#include "cli/output.hpp"
#include "picture/picture.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// Which pictures are wanted.
struct PictureArguments {
  std::string path;
  /// Empty: the camera's.
  std::vector<ViewSide> sides;

  /// Adds --picture, which refuses what is no picture's name before any work is done, and
  /// --picture-view; this must outlive the app.
  /// @param what  what is drawn, such as "the cloud and the quadrics"
  void add_to(CLI::App& command, const std::string& what);

  /// Writes one picture for each view; of several, "_VIEW" is put before the extension.
  /// @param path  of a PicturePaths
  /// @throws io::FileError if one cannot be written
  void write(const std::string& path, const PictureContent& content) const;
};

}  // namespace quadrille
