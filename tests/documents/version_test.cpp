// The version is the same wherever it stands.
#include <regex>
#include <string>

#include "documents/document.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;

TEST_CASE("programs, citation and changelog tell one version", "[documents]") {
  const std::string build = test::folded_document("CMakeLists.txt");
  std::smatch found;
  REQUIRE(std::regex_search(build, found, std::regex("project\\(quadrille VERSION ([0-9.]+)")));
  const std::string version = found[1].str();
  CHECK(test::run_quadrille("--version").out == "quadrille " + version + "\n");
  const std::string citation = test::folded_document("CITATION.cff");
  REQUIRE(std::regex_search(citation, found,
                            std::regex(" version: ([0-9.]+) date-released: ([0-9-]+) ")));
  CHECK(found[1].str() == version);
  const std::string released = "## [" + version + "] - " + found[2].str();
  CHECK(test::folded_document("CHANGELOG.md").find(released) != std::string::npos);
}
