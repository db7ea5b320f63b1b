#include "io/planner/advice.hpp"

#include "support/catch.hpp"

namespace quadrille {

TEST_CASE("a target without a grasp tells why the candidates that got furthest were refused",
          "[advice]") {
  CHECK(explain_no_grasp({7, 0, {}}) == "no way to hold it was found");
  CHECK(explain_no_grasp({7, 0, {{Refusal::kCollision, 4}}}) ==
        "collision (all 4 candidates): the hand would hit something");
  // How many failed an earlier check tells little: most directions are out of the question anyway.
  CHECK(explain_no_grasp({7, 0, {{Refusal::kUnreachable, 900}, {Refusal::kCollision, 4}}}) ==
        "collision (4 of 904 candidates, which got furthest): the hand would hit something");
}

}  // namespace quadrille
