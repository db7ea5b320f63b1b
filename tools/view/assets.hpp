#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quadrille::view {

/// One file of the page, part of the program.
struct Asset {
  /// Its path; empty for the page itself.
  std::string name;
  /// Its media type.
  const char* type;
  std::string_view content;
};

/// All there is to serve.
const std::vector<Asset>& assets();

}  // namespace quadrille::view
