#include "surfaces/heap.hpp"

#include <cmath>
#include <vector>

#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {
namespace {

constexpr double kDegree = M_PI / 180.0;
/// Height of the folds of cloth [m].
constexpr double kFolds = 0.004;

const Eigen::Isometry3d& table() {
  static const Eigen::Isometry3d X_CW = world_seen_from({0.0, -0.6, 0.6});
  return X_CW;
}

/// The top of a sphere that meets its base, the plane z = 0 of B, at an angle.
/// @param width  diameter of the base [m]
Patch cap(const Eigen::Isometry3d& X_CB, double slope, double width) {
  const double radius = 0.5 * width / std::sin(slope);
  Patch patch = sphere(X_CB * translation(0, 0, -radius * std::cos(slope)), radius);
  patch.box_B.min().z() = radius * std::cos(slope);
  return patch;
}

/// Moves the points above the plane z = 0 of B along their rays, as folds of cloth do.
void fold(const Eigen::Isometry3d& X_CB, PointCloud* cloud) {
  for (Eigen::Vector3f& p_C : cloud->points) {
    const Eigen::Vector3d p_B = X_CB.inverse() * p_C.cast<double>();
    if (!(p_B.z() > 2.0 * kFolds) || p_B.head<2>().norm() > 0.12) continue;
    const double folds = kFolds * std::sin(100.0 * p_B.x()) * std::sin(100.0 * p_B.y() + 1.0);
    p_C *= static_cast<float>(1.0 + folds / p_C.norm());
  }
}

DetectionResult found_on_table(std::vector<Patch> patches,
                               const Eigen::Isometry3d* cloth = nullptr) {
  patches.push_back(rectangle(table(), 1.2, 0.9));
  Camera camera;
  camera.noise = 0.001;
  PointCloud cloud = render(patches, camera);
  if (cloth) fold(*cloth, &cloud);
  return detect(cloud);
}

int count_curved(const DetectionResult& result) {
  int count = 0;
  for (const Detection& d : result.detections) count += !is_flat(d.type);
  return count;
}

int count_lumps(const DetectionResult& result) {
  int count = 0;
  for (const SceneBody& body : result.bodies) count += body.kind == BodyKind::kLump;
  return count;
}

TEST_CASE("what rises from a table like cloth is a lump", "[surfaces][heap]") {
  const double slope = GENERATE(25.0, 32.0, 39.0);
  CAPTURE(slope);
  const DetectionResult found = found_on_table({cap(table(), slope * kDegree, 0.2)}, &table());
  CHECK(count_curved(found) == 0);
  CHECK(count_lumps(found) == 1);
}

TEST_CASE("a smooth dome is a surface however gentle it is", "[surfaces][heap]") {
  const double slope = GENERATE(32.0, 39.0, 65.0, 90.0);
  CAPTURE(slope);
  CHECK(count_curved(found_on_table({cap(table(), slope * kDegree, 0.2)})) == 1);
}

TEST_CASE("an uneven thing that is steep at its foot is a surface", "[surfaces][heap]") {
  CHECK(count_curved(found_on_table({cap(table(), 60.0 * kDegree, 0.2)}, &table())) == 1);
}

TEST_CASE("a gentle surface whose foot is above all planes beside it is no heap",
          "[surfaces][heap]") {
  const Eigen::Isometry3d raised = table() * translation(0.0, 0.0, 0.06);
  const Patch dome = cap(raised, 32.0 * kDegree, 0.2);
  CHECK(count_curved(found_on_table({dome}, &raised)) == 1);
  // Nor is it if a box elsewhere is as high.
  std::vector<Patch> patches = box(table() * translation(0.35, 0.1, 0.03), {0.2, 0.2, 0.06});
  patches.push_back(dome);
  CHECK(count_curved(found_on_table(patches, &raised)) == 1);
}

TEST_CASE("the inner side of a shallow bowl is no heap", "[surfaces][heap]") {
  const double radius = 0.15;
  Patch bowl = sphere(table() * translation(0, 0, radius + 0.005), radius);
  bowl.box_B.max().z() = -radius * std::cos(40.0 * kDegree);
  CHECK(count_curved(found_on_table({bowl}, &table())) == 1);
}

TEST_CASE("nothing lies on a wall, so what bulges from it is a surface", "[surfaces][heap]") {
  Eigen::Isometry3d wall = table() * translation(0.0, 0.3, 0.2);
  wall.rotate(Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitX()));
  CHECK(count_curved(found_on_table({rectangle(wall, 0.8, 0.4), cap(wall, 32.0 * kDegree, 0.2)},
                                    &wall)) == 1);
}

}  // namespace
}  // namespace quadrille::test
