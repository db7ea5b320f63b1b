#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quadrille::view {

/// One file of the page, embedded in the program.
struct Asset {
  /// Path of the file; empty for the page itself.
  std::string name;
  /// Media type of the file.
  const char* type;
  std::string_view content;
};

/// Returns all files that are served.
const std::vector<Asset>& assets();

}  // namespace quadrille::view
