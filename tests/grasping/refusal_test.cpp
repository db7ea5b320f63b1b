#include "quadrille/grasping/refusal.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("the candidates that got furthest were refused by the last check", "[plan][refusal]") {
  CHECK_FALSE(furthest({}));
  CHECK(furthest({{Refusal::kCollision, 1}, {Refusal::kWidth, 900}}) == Refusal::kCollision);
  CHECK(furthest({{Refusal::kScore, 1}, {Refusal::kCollision, 50}}) == Refusal::kScore);
}

TEST_CASE("the commonest reason refused most, of equals the later check", "[plan][refusal]") {
  CHECK_FALSE(commonest({}));
  CHECK(commonest({{Refusal::kCollision, 1}, {Refusal::kWidth, 900}}) == Refusal::kWidth);
  CHECK(commonest({{Refusal::kScore, 4}, {Refusal::kWidth, 4}, {Refusal::kTwist, 3}}) ==
        Refusal::kScore);
}
