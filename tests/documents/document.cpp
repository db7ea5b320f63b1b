#include "documents/document.hpp"

#include <fstream>
#include <sstream>

#include "support/catch.hpp"

namespace quadrille::test {
namespace {

std::string folded(std::istream& in) {
  std::string text, word;
  while (in >> word) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace

std::filesystem::path repository() { return QUADRILLE_SOURCE_DIR; }

std::string folded_document(const std::string& path) {
  std::ifstream file(repository() / path);
  INFO(path);
  REQUIRE(file);
  return folded(file);
}

void check_says(const std::string& path, const std::string& sentence) {
  std::istringstream in(sentence);
  INFO(path << " should say: " << sentence);
  CHECK(folded_document(path).find(folded(in)) != std::string::npos);
}

std::vector<std::string> all_documents() {
  return {"README.md",          "ARCHITECTURE.md",        "CONTRIBUTING.md",
          "lcmtypes/README.md", "detector/src/README.md", "detector/fits/README.md",
          "examples/README.md", "tests/data/README.md",   "tools/lab/experiments/PAPER.md",
          "SECURITY.md",        "lcmtypes/LIBLCM.md",     "tools/process/README.md"};
}

}  // namespace quadrille::test
