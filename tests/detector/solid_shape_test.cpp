#include "quadrille/detector/solid_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "quadrille/detector/near_shape.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"

using namespace quadrille;

namespace {

using Support = std::function<double(const Eigen::Vector3d&)>;

struct KnownSolid {
  SolidShape shape;
  /// The largest value of u·x over the solid in its own frame, for a direction u.
  Support support;
  /// How much farther from the solid than the distance a point may be to be called near.
  double slack = 0.0;
};

double between(std::mt19937& random, double low, double high) {
  return low + (high - low) * (random() / 4294967296.0);
}

Eigen::Vector3d any_direction(std::mt19937& random) {
  for (;;) {
    const Eigen::Vector3d v(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1));
    if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
  }
}

SolidShape solid(const std::string& kind, const std::vector<double>& dimensions) {
  SolidShape shape;
  shape.kind = kind;
  shape.dimensions = dimensions;
  return shape;
}

/// A wedge, with its vertices about the origin.
SolidShape wedge() {
  SolidShape shape = solid("convex", {});
  shape.vertices_S = {{-0.05, -0.03, -0.02}, {0.05, -0.03, -0.02}, {0.05, 0.03, -0.02},
                      {-0.05, 0.03, -0.02},  {-0.05, -0.03, 0.04}, {-0.05, 0.03, 0.04}};
  // Some faces are counted the other way round, since senders do not agree on it.
  shape.faces = {4, 0, 1, 2, 3, 4, 0, 4, 5, 3, 4, 1, 2, 5, 4, 3, 0, 1, 4, 3, 2, 3, 5};
  return shape;
}

double along_vertices(const SolidShape& shape, const Eigen::Vector3d& u) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& v : shape.vertices_S) most = std::max(most, u.dot(v));
  return most;
}

std::vector<KnownSolid> known_solids() {
  const auto flat = [](const Eigen::Vector3d& u) { return std::hypot(u.x(), u.y()); };
  const SolidShape edged = wedge();
  return {
      {solid("sphere", {0.05}), [](const auto&) { return 0.05; }},
      {solid("capsule", {0.03, 0.12}), [](const auto& u) { return 0.03 + 0.06 * std::abs(u.z()); }},
      {solid("cylinder", {0.04, 0.1}),
       [=](const auto& u) { return 0.04 * flat(u) + 0.05 * std::abs(u.z()); }},
      {solid("box", {0.08, 0.06, 0.02}),
       [](const auto& u) { return u.cwiseAbs().dot(Eigen::Vector3d(0.04, 0.03, 0.01)); }},
      {solid("ellipsoid", {0.1, 0.03, 0.01}),
       [](const auto& u) { return u.cwiseProduct(Eigen::Vector3d(0.1, 0.03, 0.01)).norm(); }},
      // The edges of what is near these stay sharp: at the apex, and at their sharpest vertices, by
      // some times the distance.
      {solid("cone", {0.04, 0.1}),
       [=](const auto& u) { return std::max(0.05 * u.z(), 0.04 * flat(u) - 0.05 * u.z()); }, 1.5},
      {edged, [edged](const auto& u) { return along_vertices(edged, u); }, 4.0},
  };
}

/// Distance of a point from a convex solid: the largest distance from one of the half-spaces that
/// hold the solid. Directions all around are climbed from.
double distance_from(const Support& support, const Eigen::Vector3d& p, std::mt19937& random) {
  const auto gap = [&](const Eigen::Vector3d& u) { return u.dot(p) - support(u); };
  Eigen::Vector3d best = p.normalized();
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector3d u = any_direction(random);
    if (gap(u) > gap(best)) best = u;
  }
  for (double step = 0.3; step > 1e-7; step *= 0.93) {
    for (int n = 0; n < 6; ++n) {
      const Eigen::Vector3d u = (best + step * any_direction(random)).normalized();
      if (gap(u) > gap(best)) best = u;
    }
  }
  return std::max(gap(best), 0.0);
}

Eigen::Isometry3d any_pose(std::mt19937& random) {
  return Eigen::Translation3d(between(random, -1, 1), between(random, -1, 1),
                              between(random, 0, 2)) *
         Eigen::AngleAxisd(between(random, 0.0, 3.0), any_direction(random));
}

PointCloud lattice_cloud() {
  PointCloud cloud;
  for (int j = 0; j < 30; ++j) {
    for (int i = 0; i < 40; ++i) {
      cloud.points.emplace_back(0.01f * static_cast<float>(i), 0.01f * static_cast<float>(j), 1.0f);
    }
  }
  cloud.points[7].setConstant(std::numeric_limits<float>::quiet_NaN());
  cloud.read = cloud.points.size();
  return cloud;
}

std::string refusal(const SolidShape& shape) {
  return test::error_of([&] { shape.check(); });
}

}  // namespace

TEST_CASE("what is near a solid is told by its distance", "[shape][robot]") {
  std::mt19937 random(3);
  constexpr double kMargin = 2e-4;
  for (KnownSolid known : known_solids()) {
    int inside = 0, near = 0, outside = 0;
    for (int pose = 0; pose < 8; ++pose) {
      known.shape.X_CS = any_pose(random);
      REQUIRE(refusal(known.shape).empty());
      const double distance = std::array{0.0, 0.002, 0.01, 0.03}[pose % 4];
      const NearShape near_shape(known.shape, distance);
      for (int n = 0; n < 150; ++n) {
        const Eigen::Vector3d p_S = between(random, 0.0, 0.16) * any_direction(random);
        const Eigen::Vector3d p_C = known.shape.X_CS * p_S;
        const double gap = distance_from(known.support, p_S, random);
        CAPTURE(known.shape.kind, p_S.transpose(), distance, gap);
        if (gap <= distance - kMargin || gap == 0.0) {
          REQUIRE(near_shape.contains(p_C));
          REQUIRE(near_shape.bounds_C().contains(p_C));
          ++(gap == 0.0 ? inside : near);
        } else if (gap > (1.0 + known.slack) * distance + kMargin) {
          REQUIRE_FALSE(near_shape.contains(p_C));
          ++outside;
        }
      }
    }
    CAPTURE(known.shape.kind);
    CHECK(inside > 20);
    CHECK(near > 20);
    CHECK(outside > 100);
  }
}

TEST_CASE("a cone's apex points along its axis, and its base lies at its other end",
          "[shape][robot]") {
  SolidShape cone = solid("cone", {0.04, 0.1});
  const NearShape near(cone, 0.001);
  CHECK(near.contains({0.0, 0.0, 0.0495}));
  CHECK_FALSE(near.contains({0.01, 0.0, 0.0495}));
  CHECK(near.contains({0.038, 0.0, -0.0495}));
  CHECK_FALSE(near.contains({0.0, 0.0, -0.052}));
}

TEST_CASE("bounds hold all that is near, and little more", "[shape][robot]") {
  std::mt19937 random(4);
  for (KnownSolid known : known_solids()) {
    CAPTURE(known.shape.kind);
    const double distance = 0.01;
    // Along the axes of its own frame they end where the solid's space does.
    const Eigen::AlignedBox3d box = NearShape(known.shape, distance).bounds_C();
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d u = Eigen::Vector3d::Unit(axis);
      CHECK(box.max()[axis] == Approx(known.support(u) + distance).margin(1e-12));
      CHECK(box.min()[axis] == Approx(-known.support(-u) - distance).margin(1e-12));
    }
    known.shape.X_CS = any_pose(random);
    const Eigen::AlignedBox3d turned = NearShape(known.shape, distance).bounds_C();
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d u = Eigen::Vector3d::Unit(axis);
      const double reach = u.dot(known.shape.X_CS.translation()) +
                           known.support(known.shape.X_CS.linear().transpose() * u) + distance;
      CHECK(turned.max()[axis] >= reach - 1e-12);
    }
  }
}

TEST_CASE("points on the robot are taken from a cloud, and no others", "[robot]") {
  RobotShapes robot;
  robot.padding = 0.012;
  robot.shapes = {solid("sphere", {0.05}), solid("box", {0.1, 0.06, 0.4})};
  robot.shapes[0].X_CS.translation() = Eigen::Vector3d(0.1, 0.1, 1.01);
  robot.shapes[1].X_CS =
      Eigen::Translation3d(0.3, 0.2, 1.1) * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ());
  const auto is_robots = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3d p_C = p.cast<double>();
    const Eigen::Vector3d p_S = robot.shapes[1].X_CS.inverse() * p_C;
    const Eigen::Vector3d beyond(std::max(std::abs(p_S.x()) - 0.05, 0.0),
                                 std::max(std::abs(p_S.y()) - 0.03, 0.0),
                                 std::max(std::abs(p_S.z()) - 0.2, 0.0));
    return (p_C - Eigen::Vector3d(0.1, 0.1, 1.01)).norm() <= 0.062 || beyond.norm() <= 0.012;
  };
  PointCloud cloud = lattice_cloud();
  const bool organised = GENERATE(true, false);
  if (organised) {
    cloud.width = 40;
    cloud.height = 30;
  }
  const PointCloud things = robot.taken_from(cloud);
  CHECK(things.organised() == organised);
  CHECK(things.width == cloud.width);
  CHECK(things.height == cloud.height);
  REQUIRE(things.points.size() == cloud.points.size());
  int taken = 0;
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    if (!cloud.points[k].allFinite()) {
      CHECK_FALSE(things.points[k].allFinite());
    } else if (is_robots(cloud.points[k])) {
      CHECK(things.points[k].array().isNaN().all());
      ++taken;
    } else {
      CHECK(things.points[k] == cloud.points[k]);
    }
  }
  CHECK(taken > 100);
  CHECK(taken < 600);
  CHECK(RobotShapes{}.taken_from(cloud).points[100] == cloud.points[100]);
}

TEST_CASE("a robot's shapes move with their frame", "[robot][frames]") {
  std::mt19937 random(6);
  const PointCloud cloud = lattice_cloud();
  RobotShapes robot;
  robot.shapes = {solid("ellipsoid", {0.06, 0.1, 0.03})};
  robot.shapes[0].X_CS = Eigen::Translation3d(0.2, 0.15, 1.0) *
                         Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  const Eigen::Isometry3d X_FC = any_pose(random);
  const RobotShapes there = moved(robot, X_FC);
  const NearShape here_near(robot.shapes[0], 0.01), there_near(there.shapes[0], 0.01);
  int near = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    if (!p.allFinite()) continue;
    const Eigen::Vector3d p_C = p.cast<double>();
    // A point at the very boundary may fall on either side.
    const Eigen::Vector3d out = 1e-6 * (p_C - robot.shapes[0].X_CS.translation()).normalized();
    if (here_near.contains(p_C - out) != here_near.contains(p_C + out)) continue;
    CHECK(here_near.contains(p_C) == there_near.contains(X_FC * p_C));
    near += here_near.contains(p_C);
  }
  CHECK(near > 50);
  CHECK(there.padding == robot.padding);
}

TEST_CASE("shapes that are no solids are refused, with the reason", "[shape][robot][hostile]") {
  for (const KnownSolid& known : known_solids()) {
    CAPTURE(known.shape.kind);
    CHECK(refusal(known.shape).empty());
    SolidShape wrong = known.shape;
    wrong.X_CS.translation().y() = std::nan("");
    CHECK(refusal(wrong).find("pose") != std::string::npos);
    wrong = known.shape;
    wrong.X_CS.linear() *= 1.1;
    CHECK(refusal(wrong).find("rigid") != std::string::npos);
    for (std::size_t n = 0; n < known.shape.dimensions.size(); ++n) {
      for (const double bad : {0.0, -0.1, std::nan(""), HUGE_VAL, 1e4}) {
        wrong = known.shape;
        wrong.dimensions[n] = bad;
        CHECK(refusal(wrong).find("dimensions") != std::string::npos);
      }
    }
    if (known.shape.kind == "convex") continue;
    wrong = known.shape;
    wrong.dimensions.push_back(0.1);
    CHECK(refusal(wrong).find("dimensions") != std::string::npos);
    wrong.dimensions.clear();
    CHECK(refusal(wrong).find("dimensions") != std::string::npos);
  }
  CHECK(refusal(solid("", {0.1})).find("must be sphere") != std::string::npos);
  CHECK(refusal(solid("Sphere", {0.1})).find("must be sphere") != std::string::npos);
}

TEST_CASE("convex shapes whose faces or vertices make no sense are refused",
          "[shape][robot][hostile]") {
  const auto changed = [](const std::function<void(SolidShape&)>& change) {
    SolidShape shape = wedge();
    change(shape);
    return refusal(shape);
  };
  CHECK(changed([](SolidShape& s) { s.faces[1] = 6; }).find("vertex") != std::string::npos);
  CHECK(changed([](SolidShape& s) { s.faces[1] = -1; }).find("vertex") != std::string::npos);
  CHECK(changed([](SolidShape& s) { s.faces.pop_back(); }).find("corners") != std::string::npos);
  CHECK(changed([](SolidShape& s) { s.faces[0] = 2; }).find("corners") != std::string::npos);
  CHECK(changed([](SolidShape& s) { s.faces[0] = -4; }).find("corners") != std::string::npos);
  constexpr int kMost = std::numeric_limits<int>::max();
  CHECK(changed([](SolidShape& s) { s.faces[0] = kMost; }).find("corners") != std::string::npos);
  CHECK(changed([](SolidShape& s) { s.faces = {3, 0, 1, 2}; }).find("solid") != std::string::npos);
  CHECK(changed([](SolidShape& s) { s.faces.clear(); }).find("solid") != std::string::npos);
  CHECK_FALSE(changed([](SolidShape& s) { s.vertices_S.resize(3); }).empty());
  CHECK(changed([](SolidShape& s) { s.vertices_S[2].z() = std::nan(""); }).find("vertices") !=
        std::string::npos);
  CHECK(changed([](SolidShape& s) { s.vertices_S[2].x() = 1e4; }).find("vertices") !=
        std::string::npos);
}

TEST_CASE("a shape with a notch is not convex, one with rounded vertices is",
          "[shape][robot][hostile]") {
  // A bracket: its profile has one corner that points inwards, and two faces meet there.
  SolidShape bracket = solid("convex", {});
  const std::vector<Eigen::Vector2d> profile = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  for (const double z : {0.0, 1.0}) {
    for (const Eigen::Vector2d& p : profile) bracket.vertices_S.emplace_back(p.x(), p.y(), z);
  }
  bracket.faces = {6, 0, 1, 2, 3, 4, 5, 6, 6, 7, 8, 9, 10, 11};
  for (int k = 0; k < 6; ++k) {
    const int next = (k + 1) % 6;
    bracket.faces.insert(bracket.faces.end(), {4, k, next, next + 6, k + 6});
  }
  CHECK(refusal(bracket).find("not convex") != std::string::npos);
  bracket.vertices_S[3] = {2.5, 2.5, 0.0};
  bracket.vertices_S[9] = {2.5, 2.5, 1.0};
  CHECK(refusal(bracket).empty());
  // A file rounds its numbers.
  SolidShape rounded = wedge();
  std::mt19937 random(3);
  for (Eigen::Vector3d& v : rounded.vertices_S) {
    for (int i = 0; i < 3; ++i) v[i] += between(random, -0.0002, 0.0002);
  }
  CHECK(refusal(rounded).empty());
}

TEST_CASE("a robot's padding lies between nothing and a metre", "[robot][hostile]") {
  RobotShapes robot;
  const auto refusal_of_padding = [&](double padding) {
    robot.padding = padding;
    return test::error_of([&] { robot.check(); });
  };
  CHECK(refusal_of_padding(0.0).empty());
  CHECK(refusal_of_padding(1.0).empty());
  for (const double bad : {-0.001, 1.001, std::nan(""), HUGE_VAL}) {
    CHECK(refusal_of_padding(bad).find("padding") != std::string::npos);
  }
  robot.padding = 0.01;
  robot.shapes = {solid("sphere", {-1.0})};
  CHECK(test::error_of([&] { robot.check(); }).find("sphere") != std::string::npos);
}
