#include "quadrille/grasping/refusal.hpp"

#include <set>
#include <string_view>

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("every refusal has a name of its own", "[plan][refusal]") {
  std::set<std::string_view> names;
  for (int n = 0; n <= static_cast<int>(Refusal::kDeadline); ++n) {
    const std::string_view name = to_string(static_cast<Refusal>(n));
    CHECK_FALSE(name.empty());
    CHECK(names.insert(name).second);
  }
  CHECK(names.size() == 21);
}
