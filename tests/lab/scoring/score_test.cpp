#include "lab/scoring/score.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::scoring {
namespace {

using test::ball_at;
using test::kBallRadius;
using test::wall_at;

FrameScore score_of(const std::vector<Quadric>& findings, const std::string& only = "") {
  static const Frame frame = test::make_known_frame();
  std::vector<Found> found;
  for (const Quadric& Q : findings) found.push_back({Q, 1.0});
  return score(frame, found, only);
}

TEST_CASE("the truth itself scores full marks", "[scoring][score]") {
  const FrameScore s = score_of({ball_at(0, kBallRadius), wall_at(1.5)});
  CHECK(s.wanted == 1);
  CHECK(s.found == 1);
  CHECK(s.wrong == 0);
  CHECK(s.planes_wanted == 1);
  CHECK(s.planes_found == 1);
  CHECK(s.planes_right == 1);
  CHECK(s.planes_wrong == 0);
  REQUIRE(s.width_errors.size() == 1);
  CHECK(s.width_errors[0] < 1e-9);
  CHECK(s.widths_right == 1);
  REQUIRE(s.distances.size() == 1);
  CHECK(s.distances[0] < 1e-6);
}

TEST_CASE("findings are judged by the truth", "[scoring][score]") {
  const Quadric ball = ball_at(0, kBallRadius), missing = ball_at(0.02, kBallRadius);
  // A sphere of 300 m is the wall.
  const Quadric huge =
      from_canonical({QuadricType::kSphere, test::translation(0, 0, 301.5), {{"radius", 300.0}}});
  const struct {
    const char* what;
    std::vector<Quadric> findings;
    std::string only;
    int wanted, found, wrong, planes_found, planes_wrong;
  } cases[] = {
      {"nothing found is nothing wrong", {}, "", 1, 0, 0, 0, 0},
      {"a sphere that misses the ball", {missing}, "", 1, 0, 1, 0, 0},
      {"one within the noise", {ball_at(0.002, kBallRadius)}, "", 1, 1, 0, 0, 0},
      {"two findings of one surface", {ball, ball_at(0.001, kBallRadius)}, "", 1, 1, 1, 0, 0},
      {"what is hardly seen need not be found", {ball_at(0.5, kBallRadius)}, "", 1, 0, 0, 0, 0},
      {"one type alone counts", {ball}, "sphere", 1, 1, 0, 0, 0},
      {"another type alone counts", {ball}, "cylinder", 0, 0, 0, 0, 0},
      {"a flat finding that is no plane of the scene", {wall_at(1.3)}, "", 1, 0, 0, 0, 1},
      {"a flat finding of any type", {huge}, "", 1, 0, 0, 1, 0},
  };
  for (const auto& c : cases) {
    CAPTURE(c.what);
    const FrameScore s = score_of(c.findings, c.only);
    CHECK(s.wanted == c.wanted);
    CHECK(s.found == c.found);
    CHECK(s.wrong == c.wrong);
    CHECK(s.planes_found == c.planes_found);
    CHECK(s.planes_wrong == c.planes_wrong);
  }
}

TEST_CASE("the width is that across the line of sight", "[scoring][score]") {
  // The same front, but 3 mm larger: the front is off by the tolerance at most.
  const Quadric larger =
      from_canonical({QuadricType::kSphere, test::translation(0, 0, 1.003), {{"radius", 0.103}}});
  const FrameScore s = score_of({larger});
  REQUIRE(s.found == 1);
  CHECK(s.width_errors[0] == Approx(0.03).margin(0.002));
  CHECK(s.widths_right == 1);
}

TEST_CASE("a finding can be right where it was seen and of the wrong width", "[scoring][score]") {
  Frame frame = test::make_known_frame();
  const double sigma = frame.surfaces[0].sigma = 0.008;
  const Quadric wider =
      from_canonical({QuadricType::kSphere, test::translation(0, 0, 1.018), {{"radius", 0.118}}});
  const FrameScore s = score(frame, {{wider, 1.0}});
  REQUIRE(s.found == 1);
  CHECK(s.width_errors[0] > 0.1);
  CHECK(s.width_errors[0] * 2.0 * kBallRadius > sigma);
  CHECK(s.widths_right == 0);
}

TEST_CASE("a quadric through much more than the surface does not find it", "[scoring][score]") {
  // What is now half a ball and half something else, cut through the middle.
  Frame frame = test::make_known_frame();
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    if (frame.labels[i] == 0 && frame.cloud.points[i].x() > -0.01f) frame.labels[i] = 7;
  }
  const FrameScore s = score(frame, {{ball_at(0, kBallRadius), 1.0}});
  CHECK(s.found == 0);
  CHECK(s.wrong == 1);
}

TEST_CASE("findings beyond the hundred best, and such as are none, are wrong",
          "[scoring][score][hostile]") {
  const Frame frame = test::make_known_frame();
  std::vector<Found> found(120, Found{ball_at(3, 0.1), 0.5});
  // The best score is read first, wherever it stands.
  found.push_back({ball_at(0, kBallRadius), 0.9});
  const FrameScore s = score(frame, found);
  CHECK(s.found == 1);
  CHECK(s.wrong == 120);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Found> broken = {
      {Quadric(), 1.0}, {Quadric(Eigen::Matrix4d(Eigen::Matrix4d::Constant(nan))), 1.0}};
  CHECK(score(frame, broken).wrong == 2);
}

/// A superquadric that is a ball, at the place of the known frame's ball.
Found superball(double radius) {
  Superquadric S;
  S.axes.setConstant(radius);
  S.X_CS.translation() << 0, 0, 1;
  return {Quadric(), 1.0, S};
}

TEST_CASE("a superquadric is judged as the quadric that it equals", "[scoring][score]") {
  const Frame frame = test::make_known_frame();
  const FrameScore s = score(frame, {superball(kBallRadius)});
  CHECK(s.found == 1);
  CHECK(s.wrong == 0);
  REQUIRE(s.width_errors.size() == 1);
  CHECK(s.width_errors[0] < 1e-6);
  REQUIRE(s.distances.size() == 1);
  CHECK(s.distances[0] < 1e-4);
  const FrameScore wrong = score(frame, {superball(1.2 * kBallRadius)});
  CHECK(wrong.found == 0);
  CHECK(wrong.wrong == 1);
  CHECK(wrong.planes_wrong == 0);
  Found broken = superball(kBallRadius);
  broken.superquadric->X_CS.translation().x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(score(frame, {broken}).wrong == 1);
}

TEST_CASE("the other surfaces of its body count for a superquadric", "[scoring][score]") {
  // Two thirds of the ball become another surface: of the same body, or not.
  Frame frame = test::make_known_frame();
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    if (frame.labels[i] == 0 && frame.cloud.points[i].x() > -0.02f) frame.labels[i] = 7;
  }
  TrueSurface other = frame.surfaces[0];
  other.id = 7;
  other.evaluate = false;
  other.curved = false;
  for (const int body : {0, 9}) {
    other.body = body;
    Frame divided = frame;
    divided.surfaces.push_back(other);
    CHECK(score(divided, {superball(kBallRadius)}).found == (body == 0 ? 1 : 0));
    CHECK(score(divided, {{ball_at(0, kBallRadius), 1.0}}).found == 0);
  }
}

TEST_CASE("the truth of a generated scene scores itself as all found", "[scoring][score]") {
  const Frame frame = frame_of(scene::make_scene({scene::Family::kMedium, 3}));
  std::vector<Found> exact, shifted;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() << 0.05, 0.05, 0.05;
  for (const TrueSurface& surface : frame.surfaces) {
    if (!surface.curved) continue;
    exact.push_back({surface.Q_C, 1.0});
    shifted.push_back({surface.Q_C.transformed(X), 1.0});
  }
  const FrameScore all = score(frame, exact);
  CHECK(all.wanted >= 3);
  CHECK(all.recall() == 1.0);
  CHECK(all.precision() == 1.0);
  CHECK(score(frame, shifted).found == 0);
}

TEST_CASE("scores add up, and nothing has no share", "[scoring][score]") {
  FrameScore sum;
  CHECK(std::isnan(sum.recall()));
  CHECK(std::isnan(sum.precision()));
  sum += score_of({ball_at(0, kBallRadius), wall_at(1.5)});
  sum += score_of({ball_at(0.02, kBallRadius), wall_at(1.3)});
  CHECK(sum.wanted == 2);
  CHECK(sum.recall() == 0.5);
  CHECK(sum.precision() == 0.5);
  CHECK(sum.plane_recall() == 0.5);
  CHECK(sum.plane_precision() == 0.5);
  CHECK(sum.right_width() == 1.0);
  // A surface that was not found has a distance too.
  REQUIRE(sum.distances.size() == 2);
  CHECK(sum.distances[1] > 0.005);
  CHECK(sum.width_errors.size() == 1);
}

}  // namespace
}  // namespace quadrille::scoring
