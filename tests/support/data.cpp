#include "support/data.hpp"

#include <cstdlib>
#include <iostream>

namespace quadrille::test {

std::optional<std::filesystem::path> data_folder() {
  const char* named = std::getenv("QUADRILLE_DATA");
  const std::filesystem::path folder =
      named ? std::filesystem::path(named)
            : std::filesystem::path(QUADRILLE_SOURCE_DIR).parent_path() / "shared";
  if (std::filesystem::is_directory(folder / "data" / "real")) return folder;
  static const bool said = [&] {
    std::cerr << "QUADRILLE_DATA: no real scans at " << folder
              << "; the tests that need them do not run\n";
    return true;
  }();
  static_cast<void>(said);
  return std::nullopt;
}

}  // namespace quadrille::test
