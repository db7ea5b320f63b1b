#include "lab/physics/trial.hpp"

#include <cmath>
#include <stdexcept>

#include "lab/physics/bodies.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"

using namespace quadrille;
using Eigen::Vector3d;
using physics::TrialOptions;
using physics::TrialResult;
using physics::TrueBody;

namespace {

/// A hand from above that closes along y at the origin, far above the table.
TrialResult held(const TrueBody& body, double width, const TrialOptions& options,
                 const Vector3d& p_CG = Vector3d::Zero()) {
  Grasp grasp;
  grasp.X_CG.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  grasp.X_CG.translation() = p_CG;
  grasp.width = width;
  grasp.preshape = width + 0.014;
  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();
  X_CT.translation().z() = -0.3;
  return physics::try_grasp(body, franka_hand(), grasp, X_CT, options);
}

/// The body with its axis along x of the hand.
TrueBody lying(TrueBody body) {
  body.X_CS.linear() << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  return body;
}

TrialOptions with(double friction, double force) {
  TrialOptions options;
  options.friction = friction;
  options.force = force;
  return options;
}

/// Force of both pads' friction over the weight of a ball: 2μF/mg.
TrialResult ball_held_with(double times_weight, double friction) {
  const TrueBody ball = test::ball(0.03);
  const double weight = 9.81 * physics::mass_properties(ball, 300.0).mass;
  return held(ball, 0.06, with(friction, 0.5 * times_weight * weight / friction));
}

/// A cone of a half angle, held at its middle across its axis.
TrialResult cone_held(double degrees, double friction) {
  const double tangent = std::tan(degrees * std::numbers::pi / 180.0), middle = 0.025 / tangent;
  const TrueBody cone = lying(test::cone(tangent, 0.7 * middle, 1.3 * middle));
  return held(cone, 0.05, with(friction, 0.0), {middle, 0.0, 0.0});
}

}  // namespace

TEST_CASE("friction below a ball's weight, 2μF < mg, lets it fall", "[physics][trial]") {
  for (const double friction : {0.2, 0.5, 1.0}) {
    CAPTURE(friction);
    const TrialResult little = ball_held_with(0.9, friction);
    CHECK(little.touched);
    CHECK_FALSE(little.lifted);
    CHECK_FALSE(little.held);
    // The lift takes 1.2 times the weight and the shake 1.5.
    const TrialResult enough = ball_held_with(1.6, friction);
    CHECK(enough.held);
    CHECK(enough.slip < 0.0005);
    CHECK_FALSE(ball_held_with(1.15, friction).held);
  }
}

TEST_CASE("a cone is squeezed out if it is steeper than the friction cone", "[physics][trial]") {
  // atan 0.3 = 16.7°, atan 0.5 = 26.6°.
  CHECK(cone_held(14.0, 0.3).held);
  CHECK_FALSE(cone_held(20.0, 0.3).lifted);
  CHECK(cone_held(23.0, 0.5).held);
  CHECK_FALSE(cone_held(30.0, 0.5).lifted);
}

TEST_CASE("a bar that is held far from its middle tips if the pads press little",
          "[physics][trial]") {
  const TrueBody bar = test::block({0.06, 0.02, 0.02});
  // Its weight's lever of 50 mm takes 28 mNm; patches of 17.5 by 29 mm that press with 3 N and
  // friction 0.5 hold less than 2 μF r = 3 N · 17 mm = 51 mNm even at their corners, and about half
  // of that on average; with 70 N they hold more than twenty times as much.
  const TrialResult tipped = held(bar, 0.04, with(0.5, 3.0), {0.05, 0.0, 0.0});
  CHECK(tipped.rotation > 5.0 * std::numbers::pi / 180.0);
  CHECK_FALSE(tipped.held);
  CHECK(held(bar, 0.04, with(0.5, 70.0), {0.05, 0.0, 0.0}).held);
  CHECK(held(bar, 0.04, with(0.5, 3.0)).held);
}

TEST_CASE("light things stay where they are under much force", "[physics][trial]") {
  // Their weight is a thousandth of what friction holds: nothing but rounding could move them.
  Gripper strong = franka_hand();
  strong.finger = {0.022, 0.0252, 0.0512};
  strong.finger_front = 0.01875;
  strong.pad = {0.022, 0.0375};
  strong.max_force = 235.0;
  Grasp grasp;
  grasp.width = 0.0444;
  grasp.preshape = 0.06;
  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();
  X_CT.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  X_CT.translation().z() = 0.3;
  TrueBody can = lying(test::cylinder(0.0222, 0.0222, 0.025));
  for (const double tilt : {0.0, 0.2, 0.34}) {
    for (const double deep : {0.0, 0.008, 0.0166}) {
      CAPTURE(tilt, deep);
      TrueBody tilted = can;
      tilted.X_CS = Eigen::Translation3d(-0.0113, 0.0, deep) *
                    Eigen::AngleAxisd(tilt, Vector3d::UnitY()) * can.X_CS;
      const TrialResult result = physics::try_grasp(tilted, strong, grasp, X_CT, {});
      CHECK(result.held);
      CHECK(result.slip < 0.002);
      CHECK(result.rotation < 0.035);
    }
  }
}

TEST_CASE("an ellipsoid off its axes turns in the jaws and counts as turned", "[physics][trial]") {
  TrueBody stone = test::ellipsoid(0.03, 0.02, 0.02);
  CHECK(held(stone, 0.04, with(0.5, 0.0)).held);
  // The contacts of d at 30° lie 19° off the closing line, which friction of 0.2 (11°) lets go.
  stone.X_CS.linear() = Eigen::AngleAxisd(std::numbers::pi / 6.0, Vector3d::UnitZ()).matrix();
  const TrialResult turned = held(stone, 0.046, with(0.2, 0.0));
  CHECK(turned.rotation > 5.0 * std::numbers::pi / 180.0);
  CHECK_FALSE(turned.held);
}

TEST_CASE("a vase is held at its waist, whether full or hollow", "[physics][trial]") {
  TrueBody vase = lying(test::vase(0.02, 0.04, 0.04));
  // A hull would be 56 mm wide here; the waist is 40 mm.
  const TrialResult full = held(vase, 0.04, with(0.5, 0.0));
  CHECK(full.held);
  CHECK(full.slip < 0.001);
  vase.wall = 0.003;
  vase.open_low = vase.open_high = true;
  CHECK(held(vase, 0.043, with(0.5, 0.0)).held);
}

TEST_CASE("a cup is held by its wall with one finger inside", "[physics][trial]") {
  TrueBody cup = test::cylinder(0.04, 0.04, 0.04);
  cup.wall = 0.003;
  cup.open_high = true;
  // From above, across the wall at y = 40 mm, some millimetres below the rim.
  CHECK(held(cup, 0.005, with(0.5, 0.0), {0.0, 0.04, 0.035}).lifted);
  // Where it is full no finger gets in.
  cup.wall = 0.0;
  CHECK_FALSE(held(cup, 0.005, with(0.5, 0.0), {0.0, 0.04, 0.035}).held);
}

TEST_CASE("a hand that closes beside its object misses it", "[physics][trial]") {
  const TrialResult missed = held(test::ball(0.02), 0.03, {}, {0.06, 0.0, 0.0});
  CHECK_FALSE(missed.touched);
  CHECK_FALSE(missed.held);
}

TEST_CASE("pushing an object to the middle is no slip", "[physics][trial]") {
  const TrialResult aside = held(test::ball(0.02), 0.04, with(0.5, 0.0), {0.0, 0.003, 0.0});
  CHECK(aside.held);
  CHECK(aside.slip < 0.001);
}

TEST_CASE("a trial gives the same bits each time", "[physics][trial][determinism]") {
  const TrueBody cone = lying(test::cone(0.35, 0.05, 0.1));
  const TrialResult once = held(cone, 0.05, {}, {0.075, 0.0, 0.002});
  held(test::ball(0.02), 0.04, {});
  const TrialResult again = held(cone, 0.05, {}, {0.075, 0.0, 0.002});
  CHECK(once.slip == again.slip);
  CHECK(once.rotation == again.rotation);
  CHECK(once.slip > 0.0);
}

TEST_CASE("options that make no sense are refused by name", "[physics][trial]") {
  const auto message = [](const TrialOptions& options) {
    return test::error_of([&] { options.check(); });
  };
  TrialOptions options;
  CHECK(message(options).empty());
  CHECK(message(with(-0.1, 0.0)).find("friction") != std::string::npos);
  CHECK(message(with(0.5, std::nan(""))).find("force") != std::string::npos);
  options.density = 0.0;
  CHECK(message(options).find("density") != std::string::npos);
}
