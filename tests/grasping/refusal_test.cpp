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

TEST_CASE("the candidates that got furthest were refused by the last check", "[plan][refusal]") {
  CHECK_FALSE(furthest({}));
  CHECK(furthest({{Refusal::kCollision, 1}, {Refusal::kWidth, 900}}) == Refusal::kCollision);
  CHECK(furthest({{Refusal::kScore, 1}, {Refusal::kCollision, 50}}) == Refusal::kScore);
}
