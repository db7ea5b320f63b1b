#include <cmath>

#include "picture/picture.hpp"
#include "support/catch.hpp"
#include "tools/picture/ball_before_wall.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// True if a straight line meets a box; judged by clipping it to the box's sides.
bool meets(const Segment& line, const Eigen::AlignedBox2d& box) {
  double from = 0.0, to = 1.0;
  for (int i = 0; i < 2; ++i) {
    const double way = line.to[i] - line.from[i];
    if (std::abs(way) < 1e-12) {
      if (line.from[i] < box.min()[i] || line.from[i] > box.max()[i]) return false;
      continue;
    }
    const double a = (box.min()[i] - line.from[i]) / way, b = (box.max()[i] - line.from[i]) / way;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

}  // namespace

TEST_CASE("labels stand beside what they name, never on rims, grasps or each other", "[picture]") {
  const PointCloud cloud = ball_before_wall();
  DetectionResult result = ball_found();
  // Six more balls, some behind others.
  for (int n = 0; n < 6; ++n) {
    Detection d = result.detections.front();
    d.id = n + 2;
    const Eigen::Isometry3d away(
        Eigen::Translation3d(0.1 * (n % 3) - 0.12, 0.09 * (n / 3) - 0.05, 0.05 * n));
    d.X_CQ = away * d.X_CQ;
    d.Q_C = d.Q_C.transformed(away);
    result.detections.push_back(d);
  }
  Box box;
  box.id = 9;
  box.size = {0.2, 0.16, 0.1};
  box.X_CB =
      Eigen::Translation3d(-0.2, 0.1, 0.7) * Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX());
  result.boxes = {box};
  const GraspPlan plan = plan_on_ball();
  const Gripper gripper = make_gripper();
  for (const ViewSide side : {ViewSide::kCamera, ViewSide::kTop, ViewSide::kSide}) {
    const PictureLayout layout =
        lay_out({"balls.ply", cloud, result, &plan, &gripper}, {.side = side});
    REQUIRE(layout.labels.size() == 8);
    int hits = 0, placed = 0, overlaps = 0;
    for (const Label& label : layout.labels) {
      if (!label.place) continue;
      ++placed;
      for (const Strokes& strokes : layout.sketch.strokes) {
        for (const Segment& line : strokes.segments) hits += meets(line, label.place->box);
      }
      for (const Disc& disc : layout.sketch.discs) {
        hits += label.place->box.exteriorDistance(disc.center) < disc.radius;
      }
      for (const Label& other : layout.labels) {
        overlaps +=
            &other != &label && other.place && other.place->box.intersects(label.place->box);
      }
    }
    CHECK(placed == 8);
    CHECK(hits == 0);
    CHECK(overlaps == 0);
  }
}

TEST_CASE("a leader line ends on the rim of the ball that its label names", "[picture]") {
  const PointCloud cloud = ball_before_wall();
  const DetectionResult result = ball_found();
  const PictureLayout layout = lay_out({"ball.ply", cloud, result});
  REQUIRE(layout.labels.size() == 1);
  REQUIRE(layout.labels[0].place);
  // Rays to the rim touch the ball: its centre lies 0.1 m off them.
  const Eigen::Vector2d end = layout.labels[0].place->anchor;
  const Eigen::Vector3d ray = layout.view.ray(end.x(), end.y()).normalized();
  CHECK(ray.cross(Eigen::Vector3d(0, 0, 0.6)).norm() == Approx(0.1).margin(0.001));
}

TEST_CASE("a label without room is left out", "[picture]") {
  TakenCells lines(400, 300), bodies(400, 300);
  lines.mark(Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(400, 300)));
  const WantedLabel label{{80, 20}, {{200, 150}}};
  CHECK_FALSE(place_labels({label}, {400, 300}, lines, bodies)[0]);
  CHECK_FALSE(place_labels({{{500, 20}, {{200, 150}}}}, {400, 300}, {400, 300}, bodies)[0]);
  CHECK(place_labels({label}, {400, 300}, {400, 300}, lines)[0]);
}
