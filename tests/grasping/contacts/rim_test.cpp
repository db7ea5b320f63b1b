#include "contacts/rim.hpp"

#include "body/find_shell.hpp"
#include "grasping/cup.hpp"
#include "hand/hand.hpp"
#include "quadrille/grasping/plan.hpp"
#include "space/collision.hpp"
#include "support/catch.hpp"
#include "view/depth_view.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

const Eigen::Vector3d kUp = table_detection().X_CQ.linear().col(2);

std::optional<Shell> shell_of(const Cup& cup, bool inner) {
  const PointCloud cloud = render(cup);
  const Detection d = wall_detection(cup, inner);
  const Body body = make_body(d).value();
  return find_shell(body, seen_from_inside(d, body), cloud, DepthView(cloud), kUp, {});
}

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

TEST_CASE("an open cup has a mouth on top, a closed can has none", "[rim]") {
  for (const bool inner : {false, true}) {
    const std::optional<Shell> shell = shell_of({}, inner);
    REQUIRE(shell);
    CHECK(shell->seen_inside == inner);
    CHECK(shell->body.X_CQ.linear().col(2).dot(kUp) == Approx(1.0));
  }
  Cup can;
  can.closed = true;
  CHECK_FALSE(shell_of(can, false));
}

TEST_CASE("a rim is raised to where the points on the wall end, and no farther", "[rim]") {
  const Cup cup;
  const PointCloud cloud = render(cup);
  for (const double missing : {0.0, 0.002, 0.005}) {
    CAPTURE(missing);
    Detection d = wall_detection(cup, false);
    d.extent_Q.min().z() += missing;  // whichever end is up
    d.extent_Q.max().z() -= missing;
    const Body body = make_body(d).value();
    const std::optional<Shell> shell = find_shell(body, false, cloud, DepthView(cloud), kUp, {});
    REQUIRE(shell);
    CHECK(shell->body.z_max == Approx(0.5 * cup.height).margin(0.0015));
  }
}

TEST_CASE("a ball on a table has no mouth", "[rim]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.05);
  const PointCloud cloud = render({ball});
  const Body body = make_body(sphere_detection(ball)).value();
  CHECK_FALSE(find_shell(body, false, cloud, DepthView(cloud), kUp, {}));
}

TEST_CASE("the signed distance of a shell vanishes on its surface and grows along normals",
          "[rim]") {
  for (const Detection& d : solid_detections()) {
    if (d.type == QuadricType::kParallelPlanes) continue;
    const Shell shell{make_body(d).value(), false, {}};
    CAPTURE(to_string(d.type));
    for (int k = 0; k < 12; ++k) {
      const double z = shell.body.z_min + (0.3 + 0.04 * k) * (shell.body.z_max - shell.body.z_min);
      const Eigen::Vector3d p = shell.point_Q(0.5 * k, z), n = shell.normal_Q(0.5 * k, z);
      const auto at = [&](double off) { return shell.offset(shell.body.X_CQ * (p + off * n)); };
      CHECK(at(0.0) == Approx(0.0).margin(1e-9));
      CHECK(at(0.002) == Approx(0.002).epsilon(0.15));
      CHECK(at(-0.002) == Approx(-0.002).epsilon(0.15));
    }
  }
}

TEST_CASE("rim lines lie across the wall below the rim with room for its bend", "[rim]") {
  for (const bool inner : {false, true}) {
    const Cup cup;
    const Shell shell = shell_of(cup, inner).value();
    const auto lines = rim_lines(shell, franka_hand());
    REQUIRE(lines.size() == 72);
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

TEST_CASE("the wall's shapes hold all of the wall and leave the hollow open", "[rim][shape]") {
  std::mt19937 random(21);
  for (const Detection& d : solid_detections()) {
    if (d.type == QuadricType::kParallelPlanes) continue;
    for (const bool inside : {false, true}) {
      const Shell shell{make_body(d).value(), inside, {0.002, 0.004}};
      const auto pieces = make_wall(shell);
      const auto covered = [&](const Eigen::Vector3d& p_Q) {
        const OrientedBox dot{Eigen::Matrix3d::Identity(), shell.body.X_CQ * p_Q,
                              Eigen::Vector3d::Constant(0.0003)};
        return std::any_of(pieces.begin(), pieces.end(),
                           [&](const CollisionShape& piece) { return overlaps(dot, piece); });
      };
      CAPTURE(to_string(d.type), inside);
      const double height = shell.body.z_max - shell.body.z_min;
      for (int n = 0; n < 60; ++n) {
        const double z = shell.body.z_max - uniform(random, 0.05, 0.45) * height;
        const double angle = uniform(random, 0.0, 6.28);
        const double off = uniform(random, shell.inner(), shell.outer());
        CHECK(covered(shell.point_Q(angle, z) + off * shell.normal_Q(angle, z)));
      }
      CHECK_FALSE(covered({0.0, 0.0, shell.body.z_max - 0.3 * height}));
    }
  }
}

TEST_CASE("a cup wider than the hand is held by its rim and no hand touches the cup",
          "[rim][plan][collision]") {
  const Cup cup;
  const PointCloud cloud = render(cup);
  const Eigen::Isometry3d X_TC = table_detection().X_CQ.inverse();
  for (const bool inner : {false, true}) {
    for (const UnknownPolicy policy : {UnknownPolicy::kTargetShadow, UnknownPolicy::kFree}) {
      PlanOptions options;
      options.unknown = policy;
      const GraspPlan plan = plan_grasps(cloud, {wall_detection(cup, inner), table_detection()},
                                         franka_hand(), options);
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
