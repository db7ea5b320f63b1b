#include <fstream>
#include <sstream>
#include <string>

#include "documents/document.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;

TEST_CASE("the page of settings is what quadrille config prints", "[documents]") {
  std::ostringstream page;
  page << std::ifstream(test::repository() / "tools/quadrille/SETTINGS.md").rdbuf();
  const test::Run printed = test::run_quadrille("config --defaults");
  REQUIRE(printed.code == 0);
  // If not: put the output of `quadrille config --defaults` into the block there.
  CHECK(page.str().find("```toml\n" + printed.out + "```\n") != std::string::npos);
}
