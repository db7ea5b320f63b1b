#include "io/planner/advice.hpp"

#include "support/catch.hpp"

namespace quadrille {

TEST_CASE("a target without a grasp tells why the furthest and why most were refused", "[advice]") {
  CHECK(explain_no_grasp({7, 0, {}}) == "no way to hold it was found");
  CHECK(explain_no_grasp({7, 0, {{Refusal::kCollision, 4}}}) ==
        "collision (all 4 candidates): the hand would hit other things");
  // The two are the same.
  CHECK(explain_no_grasp({7, 0, {{Refusal::kTwist, 1}, {Refusal::kCollision, 4}}}) ==
        "collision (4 of 5 candidates, which got furthest): the hand would hit other things");
  CHECK(explain_no_grasp({7, 0, {{Refusal::kUnreachable, 900}, {Refusal::kCollision, 4}}}) ==
        "collision (4 of 904 candidates, which got furthest): the hand would hit other things; "
        "most, 900, were refused as unreachable: it can only be approached from behind or below");
}

}  // namespace quadrille
