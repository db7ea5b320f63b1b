#include "body/find_shell.hpp"

#include "grasping/seen_cup.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

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
    const std::optional<Shell> shell =
        find_shell(body, false, cloud, std::vector{DepthView(cloud)}, kUp, {});
    REQUIRE(shell);
    CHECK(shell->body.z_max == Approx(0.5 * cup.height).margin(0.0015));
  }
}

TEST_CASE("a ball on a table has no mouth", "[rim]") {
  const Ball ball = ball_on_table(0.0, 0.0, 0.05);
  const PointCloud cloud = render({ball});
  const Body body = make_body(sphere_detection(ball)).value();
  CHECK_FALSE(find_shell(body, false, cloud, std::vector{DepthView(cloud)}, kUp, {}));
}
