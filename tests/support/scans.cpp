#include "support/scans.hpp"

namespace quadrille::test {

std::filesystem::path scans_folder() {
  return std::filesystem::path(QUADRILLE_SOURCE_DIR) / "tests" / "data";
}

}  // namespace quadrille::test
