#include "quadrille/detector/known_detection.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"
#include "support/quadric_points.hpp"

namespace quadrille {
namespace {

using Values = std::map<std::string, double>;

struct KnownCase {
  QuadricType type;
  Values values;
  /// A point on the surface, and one beside it, in frame Q.
  Eigen::Vector3d on, outside;
};

const Eigen::AlignedBox3d kExtent(Eigen::Vector3d(-0.1, -0.1, -0.1),
                                  Eigen::Vector3d(0.1, 0.1, 0.1));

TEST_CASE("a known surface has its type, its place and the side that it shows", "[frames]") {
  RandomStream random(21, 0);
  const std::vector<KnownCase> cases = {
      {QuadricType::kSphere, {{"radius", 0.05}}, {0, 0.03, 0.04}, {0, 0, 0.1}},
      {QuadricType::kEllipsoid, {{"a", 0.09}, {"b", 0.05}, {"c", 0.03}}, {0, 0.05, 0}, {0, 0, 0.1}},
      {QuadricType::kCylinder, {{"radius", 0.05}, {"length", 0.2}}, {0.03, 0.04, 0.1}, {1, 0, 0}},
      {QuadricType::kEllipticCylinder,
       {{"a", 0.06}, {"b", 0.03}, {"length", 0.2}},
       {0, 0.03, 0.07},
       {0, 0.1, 0}},
      {QuadricType::kCone, {{"half_angle", 0.25 * M_PI}}, {0.03, 0.04, 0.05}, {1, 0, 0.1}},
      {QuadricType::kEllipticParaboloid,
       {{"focal_a", 0.05}, {"focal_b", 0.02}},
       {0.1, 0, 0.05},
       {0, 0, -0.1}},
      {QuadricType::kPlane, {{"width", 0.6}, {"height", 0.4}}, {0.2, 0.1, 0}, {0, 0, 0.1}},
      {QuadricType::kParallelPlanes, {{"distance", 0.04}}, {1, 1, 0.02}, {0, 0, 0.1}},
  };
  for (const KnownCase& known : cases) {
    CAPTURE(to_string(known.type));
    const Eigen::Isometry3d X_CQ = test::random_pose(random, 0.5);
    const Detection d = known_detection(known.type, X_CQ, known.values, kExtent);
    CHECK(canonical_form(d.Q_C, 1e-6).type == known.type);
    CHECK(std::abs(d.Q_C.distance(X_CQ * known.on)) < 1e-9);
    CHECK(d.Q_C.value(X_CQ * known.outside) > 0.0);
    CHECK(d.Q_C.coefficients().norm() == Approx(1.0));
    CHECK(d.X_CQ.matrix() == rounded(X_CQ).matrix());
    CHECK(d.dimensions.size() == known.values.size());
    CHECK(is_reported(d));
    const Detection inside = known_detection(known.type, X_CQ, known.values, kExtent, true);
    CHECK(inside.Q_C.matrix() == -d.Q_C.matrix());
  }
}

TEST_CASE("the extent of a surface that its dimensions bound is known too", "[frames]") {
  const Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  const Detection can =
      known_detection(QuadricType::kCylinder, X, {{"length", 0.2}, {"radius", 0.05}});
  CHECK(can.extent_Q.isApprox(
      Eigen::AlignedBox3d(Eigen::Vector3d(-0.05, -0.05, -0.1), Eigen::Vector3d(0.05, 0.05, 0.1))));
  CHECK(can.dimensions[0].name == "radius");
  CHECK_FALSE(shows_inside(can));
  CHECK(shows_inside(known_detection(QuadricType::kSphere, X, {{"radius", 0.1}}, {}, true)));
}

TEST_CASE("what makes no known surface is refused with the name of what is wrong", "[frames]") {
  const Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  const auto error = [&](QuadricType type, const Values& values) {
    return test::error_of([&] { known_detection(type, X, values); });
  };
  CHECK(error(QuadricType::kCylinder, {{"radius", 0.1}}).find("radius, length") !=
        std::string::npos);
  CHECK(error(QuadricType::kSphere, {{"radius", 0.1}, {"size", 1}}).find("radius") !=
        std::string::npos);
  CHECK(error(QuadricType::kSphere, {{"radius", -0.1}}).find("radius") != std::string::npos);
  CHECK(error(QuadricType::kCone, {{"half_angle", 2.0}}).find("half_angle") != std::string::npos);
  CHECK(error(QuadricType::kCone, {{"half_angle", 0.3}}).find("extent") != std::string::npos);
  CHECK(error(QuadricType::kIntersectingPlanes, {{"angle", 4.0}}).find("half a turn") !=
        std::string::npos);
  const Eigen::AlignedBox3d far(Eigen::Vector3d(5, 5, 5), Eigen::Vector3d(6, 6, 6));
  CHECK(test::error_of([&] {
          known_detection(QuadricType::kSphere, X, {{"radius", 0.1}}, far);
        }).find("extent") != std::string::npos);
  CHECK(error(QuadricType::kImaginaryCone, {}).find("no real surface") != std::string::npos);
  Eigen::Isometry3d twice = X;
  twice.linear() *= 2.0;
  CHECK(test::error_of([&] { known_box(twice, {1, 1, 1}); }).find("X_CB") != std::string::npos);
  CHECK(test::error_of([&] { known_box(X, {1, 0, 1}); }).find("sides") != std::string::npos);
}

TEST_CASE("only rotations with a translation are poses", "[frames]") {
  Eigen::Isometry3d X = Eigen::Translation3d(1, -2, 3) * Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  CHECK(checked_pose(X, "X_AB").matrix() == X.matrix());
  const auto error = [](const Eigen::Matrix4d& X) {
    return test::error_of([&] { checked_pose(Eigen::Isometry3d(X), "X_AB"); });
  };
  Eigen::Matrix4d mirrored = X.matrix(), skewed = X.matrix(), lost = X.matrix(),
                  scaled = X.matrix();
  mirrored.col(0) *= -1.0;
  skewed(0, 0) += 1e-5;
  lost(1, 3) = std::nan("");
  scaled(3, 3) = 2.0;
  for (const Eigen::Matrix4d& wrong : {mirrored, skewed, lost, scaled}) {
    CHECK(error(wrong) == "X_AB is no rotation and translation");
  }
}

TEST_CASE("a known box is as large as it is said to be", "[frames]") {
  const Box box = known_box(Eigen::Isometry3d::Identity(), {0.3, 0.2, 0.1});
  CHECK(box.inner_B.sizes().isApprox(box.size));
  CHECK(box.outer_B.center().isZero());
  CHECK(is_reported(box));
}

}  // namespace
}  // namespace quadrille
