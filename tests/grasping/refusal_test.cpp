#include "quadrille/grasping/refusal.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("the candidates that got furthest were refused by the last check", "[plan][refusal]") {
  CHECK_FALSE(furthest({}));
  CHECK(furthest({{Refusal::kCollision, 1}, {Refusal::kWidth, 900}}) == Refusal::kCollision);
  CHECK(furthest({{Refusal::kScore, 1}, {Refusal::kCollision, 50}}) == Refusal::kScore);
}
