#include "surfaces/point_rms.hpp"

#include <cmath>

#include "detector/table_scene.hpp"
#include "quadrille/detector/detection.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Noise of each point along z at 1 m [m].
constexpr double kNoise = 0.0008;

PointCloud ball_before_wall() {
  Camera camera;
  camera.noise = kNoise;
  return render({rectangle(translation(0, 0, 1.0), 1e3, 1e3), sphere(translation(0, 0, 0.8), 0.1)},
                camera);
}

/// One quadric for the cells nearer than the wall, and one for those of the wall.
std::vector<int> near_and_far(const CellPyramid& pyramid) {
  std::vector<int> owner;
  for (int c = 0; c < pyramid.size(0); ++c) {
    owner.push_back(pyramid.count(c) == 0 ? -1 : pyramid.mean(c).z() < 0.9f ? 0 : 1);
  }
  return owner;
}

std::vector<Quadric> ball_and_wall() {
  Eigen::Matrix4d plane = Eigen::Matrix4d::Zero();
  plane(2, 3) = plane(3, 2) = 0.5;
  const auto at = [](double z) { return Eigen::Isometry3d(Eigen::Translation3d(0, 0, z)); };
  return {Quadric(diagonal(1, 1, 1, -0.01)).transformed(at(0.8)),
          Quadric(plane).transformed(at(1.0))};
}

/// The same sums over all points by hand: those in front of z belong to the ball.
std::vector<double> rms_of_all(const PointCloud& cloud) {
  const std::vector<Quadric> quadrics = ball_and_wall();
  double squares[2] = {}, n[2] = {};
  for (const Eigen::Vector3f& p : cloud.points) {
    if (!p.allFinite()) continue;
    const Eigen::Vector3d x = p.cast<double>();
    const int side = x.z() < 0.9 ? 0 : 1;
    squares[side] += std::pow(quadrics[side].distance(x), 2);
    n[side] += 1;
  }
  return {std::sqrt(squares[0] / n[0]), std::sqrt(squares[1] / n[1])};
}

/// The rms of one view's points.
std::vector<double> rms_of_points(const PointCloud& cloud, const CellPyramid& pyramid,
                                  const std::vector<int>& owner,
                                  const std::vector<Quadric>& quadrics) {
  PointRms rms(quadrics);
  rms.add(cloud, pyramid, owner);
  return rms.values();
}

}  // namespace

TEST_CASE("the rms is that of the points, not of their cells' means", "[surfaces][rms]") {
  const PointCloud cloud = ball_before_wall();
  const std::vector<double> truth = rms_of_all(cloud);
  REQUIRE(truth[1] == Approx(kNoise).epsilon(0.02));
  for (const auto& pyramid : {make_depth_pyramid(cloud, {}), make_voxel_pyramid(cloud, {})}) {
    REQUIRE(pyramid);
    const std::vector<double> rms =
        rms_of_points(cloud, *pyramid, near_and_far(*pyramid), ball_and_wall());
    REQUIRE(rms.size() == 2);
    CHECK(rms[0] == Approx(truth[0]).epsilon(0.05));
    CHECK(rms[1] == Approx(truth[1]).epsilon(0.05));
  }
}

TEST_CASE("the rms of several views is that of all their points", "[surfaces][rms]") {
  const PointCloud cloud = ball_before_wall();
  const auto pyramid = make_depth_pyramid(cloud, {});
  const std::vector<int> owner = near_and_far(*pyramid);
  const std::vector<Quadric> quadrics = ball_and_wall();
  const std::vector<double> once = rms_of_points(cloud, *pyramid, owner, quadrics);
  PointRms twice(quadrics);
  twice.add(cloud, *pyramid, owner);
  twice.add(cloud, *pyramid, owner);
  CHECK(twice.values()[0] == Approx(once[0]));
  CHECK(twice.values()[1] == Approx(once[1]));
  PointRms mixed(quadrics);
  mixed.add(cloud, *pyramid, owner);
  PointCloud noisy = cloud;
  for (Eigen::Vector3f& p : noisy.points) p *= 1.002f;
  mixed.add(noisy, *pyramid, owner);
  const std::vector<double> other = rms_of_points(noisy, *pyramid, owner, quadrics);
  CHECK(mixed.values()[1] > once[1]);
  CHECK(mixed.values()[1] < other[1]);
}

TEST_CASE("what has no points gets no rms", "[surfaces][rms]") {
  const PointCloud cloud = ball_before_wall();
  const auto pyramid = make_depth_pyramid(cloud, {});
  const std::vector<int> nobody(static_cast<std::size_t>(pyramid->size(0)), -1);
  for (const double rms : rms_of_points(cloud, *pyramid, nobody, ball_and_wall())) {
    CHECK(std::isnan(rms));
  }
}

TEST_CASE("the spread of a plane is the sensor's, in the camera's frame and in another",
          "[surfaces][rms][detector]") {
  Camera camera;
  camera.noise = kNoise;
  const PointCloud cloud = render(
      {rectangle(translation(0, 0, 1.0), 1e3, 1e3), sphere(translation(0, 0, 0.9), 0.1)}, camera);
  Eigen::Isometry3d X = translation(0.4, -0.3, 0.7);
  X.rotate(Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, 1, 0.2).normalized()));
  for (const PointCloud& c : {cloud, moved(cloud, X)}) {
    const DetectionResult result = detect(c);
    const Detection* plane = find(result, QuadricType::kPlane);
    const Detection* ball = find(result, QuadricType::kSphere);
    REQUIRE(plane);
    REQUIRE(ball);
    CHECK(plane->rms == Approx(kNoise).epsilon(0.1));
    // Seen aslant the noise along the ray is less than that along the normal.
    CHECK(ball->rms > 0.4 * kNoise);
    CHECK(ball->rms < 1.1 * kNoise);
  }
}
