#pragma once

#include <string>
#include <vector>

#include "cli/output.hpp"
#include "picture/picture.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The arguments that select pictures.
struct PictureArguments {
  std::string path;
  /// The views; if empty, the camera's.
  std::vector<ViewSide> sides;

  /// Adds --picture, which refuses a path that is not that of a picture before any work is done,
  /// and --picture-view; this object must outlive the app.
  /// @param what  what is drawn, such as "the cloud and the quadrics"
  void add_to(CLI::App& command, const std::string& what);

  /// Writes one picture for each view; if there are several, "_VIEW" is inserted before the
  /// extension.
  /// @param path  path from PicturePaths
  /// @throws io::FileError if a picture cannot be written
  void write(const std::string& path, const PictureContent& content) const;
};

}  // namespace quadrille
