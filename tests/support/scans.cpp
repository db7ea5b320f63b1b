#include "support/scans.hpp"

namespace quadrille::test {

std::filesystem::path scans_folder() {
  return std::filesystem::path(QUADRILLE_SOURCE_DIR) / "tests" / "data";
}

std::filesystem::path corpus_folder(const std::string& fuzzer) {
  return std::filesystem::path(QUADRILLE_SOURCE_DIR) / "tests/corpus" / fuzzer;
}

}  // namespace quadrille::test
