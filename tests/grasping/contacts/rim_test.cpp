#include "contacts/rim.hpp"

#include "grasping/plans.hpp"
#include "grasping/seen_cup.hpp"
#include "hand/hand.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Points all through the box, half a millimetre within its faces and 2 mm apart.
template <class Visitor>
void each_point(const OrientedBox& box, Visitor&& visit) {
  const Eigen::Vector3d half = box.half.array() - 0.0005;
  const Eigen::Array3i n = (half.array() / 0.001).ceil().cast<int>().max(1);
  for (int i = 0; i <= n.x(); ++i) {
    for (int j = 0; j <= n.y(); ++j) {
      for (int k = 0; k <= n.z(); ++k) {
        const Eigen::Vector3d share = 2.0 * Eigen::Array3d(i, j, k) / n.cast<double>() - 1.0;
        visit(Eigen::Vector3d(box.p_CB + box.R_CB * half.cwiseProduct(share)));
      }
    }
  }
}

}  // namespace

TEST_CASE("rim lines lie across the wall below the rim with room for its bend", "[rim]") {
  for (const bool inner : {false, true}) {
    const Cup cup;
    const Shell shell = shell_of(cup, inner).value();
    const auto lines = rim_lines(shell, franka_hand());
    REQUIRE(lines.size() == 108);
    const double r = inner ? cup.radius - cup.wall : cup.radius;
    const double half = 0.5 * franka_hand().finger.x();
    for (const ContactLine& line : lines) {
      const Eigen::Vector3d seen = shell.body.X_CQ.inverse() * line.contacts_C[inner ? 1 : 0];
      CHECK(seen.head<2>().norm() == Approx(r));
      CHECK(seen.z() < shell.body.z_max);
      CHECK(std::abs(line.closing_C.dot(kUp)) < 1e-9);
      // A wall of 5 mm in the middle, and room for one of 8 mm on its unseen side.
      const double bend = r - std::sqrt(r * r - half * half);
      CHECK(line.opening == Approx(0.005 + bend + 2.0 * 0.003));
      const double middle = (shell.body.X_CQ.inverse() * line.centre_C).head<2>().norm();
      CHECK(middle == Approx(r + (inner ? 0.0025 : -0.0025) - 0.5 * bend));
    }
  }
}

TEST_CASE("small pads hold a rim nearer to its edge, large ones no farther from it", "[rim]") {
  const Shell shell = shell_of({}, false).value();
  const auto below = [&](double scale) {
    Gripper hand = franka_hand();
    hand.pad.x() *= scale;
    CHECK(rim_reach(hand) == Approx(0.009 * scale));
    std::vector<double> heights;
    for (const ContactLine& line : rim_lines(shell, hand)) {
      const Eigen::Vector3d seen_Q = shell.body.X_CQ.inverse() * line.contacts_C[0];
      heights.push_back(shell.body.z_max - seen_Q.z());
    }
    return heights;
  };
  const std::vector<double> usual = below(1.0), small = below(0.5);
  CHECK(below(2.0) == usual);
  REQUIRE(small.size() == usual.size());
  for (std::size_t n = 0; n < small.size(); ++n) CHECK(small[n] == Approx(0.5 * usual[n]));
}

TEST_CASE("only where points were measured does a rim line remain", "[rim]") {
  const Cup cup;
  const Shell shell = shell_of(cup, false).value();
  const auto lines = rim_lines(shell, franka_hand());
  CHECK(measured_lines(shell, franka_hand(), lines, {}).empty());
  const auto measured = measured_lines(shell, franka_hand(), lines, render(cup));
  CHECK(measured.size() > 20);
  for (const ContactLine& line : measured) CHECK(line.std < 0.001);
  PointCloud off = render(cup);  // 12 mm beside the wall: another one's points
  for (Eigen::Vector3f& p : off.points) p += Eigen::Vector3f(0.0f, 0.0f, 0.2f);
  CHECK(measured_lines(shell, franka_hand(), lines, off).empty());
}

TEST_CASE("a wall that ends below the middle of the pads is not held there", "[rim]") {
  const Cup cup;
  const Shell shell = shell_of(cup, false).value();
  const auto lines = rim_lines(shell, franka_hand());
  const PointCloud cloud = render(cup);
  const Eigen::Isometry3d X_QC = shell.body.X_CQ.inverse();
  const auto cut_at = [&](double below) {
    PointCloud cut = cloud;
    std::erase_if(cut.points, [&](const Eigen::Vector3f& p_C) {
      return (X_QC * p_C.cast<double>()).z() > shell.body.z_max - below;
    });
    return measured_lines(shell, franka_hand(), lines, cut);
  };
  CHECK(cut_at(0.005).size() > 10);
  // The deepest lines lie 13 mm below the rim, and points up to 9 mm below them are near them.
  CHECK(cut_at(0.014).empty());
}

TEST_CASE("a cup wider than the hand is held by its rim and no hand touches the cup",
          "[rim][plan][collision]") {
  const Cup cup;
  const PointCloud cloud = render(cup);
  const Eigen::Isometry3d X_TC = table_detection().X_CQ.inverse();
  for (const bool inner : {false, true}) {
    for (const UnknownPolicy policy : {UnknownPolicy::kTargetShadow, UnknownPolicy::kFree}) {
      const GraspPlan plan = plan_grasps(cloud, {wall_detection(cup, inner), table_detection()},
                                         franka_hand(), with(policy));
      CAPTURE(inner, static_cast<int>(policy), plan.rejected);
      REQUIRE_FALSE(plan.grasps.empty());
      for (const Grasp& g : plan.grasps) {
        CHECK(g.width < 0.01);
        CHECK(g.friction_needed == Approx(0.0).margin(1e-6));
        const SweptHand hand = sweep_hand(franka_hand(), g.X_CG, g.preshape, g.width, g.approach);
        bool touches = false, holds = false;
        for (const OrientedBox& box : {hand.fingers[0], hand.fingers[1], hand.palm}) {
          each_point(box, [&](const Eigen::Vector3d& p) { touches |= cup.holds(X_TC * p); });
        }
        CHECK_FALSE(touches);
        each_point(box_between(g.X_CG, {-0.008, -0.5 * g.preshape, -0.009},
                               {0.008, 0.5 * g.preshape, 0.009}),
                   [&](const Eigen::Vector3d& p) { holds |= cup.holds(X_TC * p); });
        CHECK(holds);
      }
    }
  }
}

TEST_CASE("a hollow without a seen rim is refused as seen from inside", "[rim][plan]") {
  Cup can;
  can.closed = true;
  const GraspPlan plan =
      plan_grasps(render(can), {wall_detection(can, true), table_detection()}, franka_hand());
  CHECK(plan.grasps.empty());
  CHECK(plan.rejected.at("seen_from_inside") == 1);
}
