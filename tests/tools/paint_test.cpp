#include "cli/paint.hpp"

#include <cstdlib>

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("text is painted only where it is wanted", "[command]") {
  CHECK(Paint(false).head("id") == "id");
  CHECK(Paint(true).head("id") == "\033[1mid\033[0m");
  CHECK(Paint(true).bad("lost") == "\033[31mlost\033[0m");
}
