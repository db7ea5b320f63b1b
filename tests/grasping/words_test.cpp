#include "support/words.hpp"

#include "quadrille/grasping/conventions.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "quadrille/grasping/refusal.hpp"

using namespace quadrille;

TEST_CASE("each value of the planner's enumerations has a word of its own", "[words]") {
  test::check_words(HandConvention::kGraspnet);
  test::check_words(GraspKind::kTip);
  test::check_words(Voxel::kOccupied);
  test::check_words(UnknownPolicy::kFree);
  test::check_words(Refusal::kDeadline);

  CHECK(to_string(Voxel::kClear) == "clear");
}

TEST_CASE("kinds of grasps and policies have the names of files and messages", "[words][plan]") {
  CHECK(to_string(GraspKind::kAcross) == "across");
  CHECK(to_string(GraspKind::kTip) == "tip");
  CHECK(to_string(UnknownPolicy::kTargetShadow) == "target-shadow");
}
