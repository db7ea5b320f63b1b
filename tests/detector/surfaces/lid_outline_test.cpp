#include "surfaces/lid_outline.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kLidRadius = 0.05, kLidHeight = 0.12;
// Distance of the camera from the lid's middle, and between the points there [m].
constexpr double kEyeDistance = 0.6, kPointPitch = kEyeDistance / 400.0;

/// A round lid at the origin of L, z up, seen from above.
struct SeenLid {
  Lid lid;
  std::vector<Eigen::Vector3d> points_C;

  /// @param elevation  of the eye over the lid [rad]
  /// @param others_L   what else is seen, in frame L
  explicit SeenLid(double elevation, std::vector<Patch> others_L = {}) {
    lid.X_CL = world_seen_from(kEyeDistance *
                               Eigen::Vector3d(0, -std::cos(elevation), std::sin(elevation)));
    Patch top = rectangle(Eigen::Isometry3d::Identity(), 1.0, 1.0);
    top.within = diagonal(1, 1, 0, -kLidRadius * kLidRadius);
    others_L.push_back(top);
    for (Patch& patch : others_L) patch.X_CB = lid.X_CL * patch.X_CB;
    Camera camera;
    camera.pitch = 1.0 / 400.0;
    const Eigen::Isometry3d X_LC = lid.X_CL.inverse();
    for (const Eigen::Vector3f& p : render(others_L, camera).points) {
      const Eigen::Vector3d p_C = p.cast<double>();
      if (!p_C.allFinite()) continue;
      points_C.push_back(p_C);
      const Eigen::Vector3d p_L = X_LC * p_C;
      if (std::abs(p_L.z()) < 1e-5 && p_L.norm() < kLidRadius) lid.places_C.push_back(p_C);
    }
    lid.cell = 4.0 * kPointPitch;
  }

  /// The outline in frame L.
  std::vector<Eigen::Vector3d> outline() const {
    std::vector<Eigen::Vector3d> outline_L;
    for (const OutlinePoint& o : outline_of(lid, points_C, Eigen::Vector3d::Zero())) {
      CHECK(o.std > 0.0);
      outline_L.push_back(lid.X_CL.inverse() * o.p_C);
    }
    return outline_L;
  }
};

/// A floor below the lid.
Patch ground() { return rectangle(translation(0, 0, -kLidHeight), 3.0, 3.0); }

}  // namespace

TEST_CASE("the outline of a lid before a floor is its far edge, within a pixel", "[lid]") {
  for (const double elevation : {0.4, 0.8, 1.3}) {
    CAPTURE(elevation);
    const std::vector<Eigen::Vector3d> outline = SeenLid(elevation, {ground()}).outline();
    CHECK(outline.size() > 10);
    // A pixel is stretched along the lid.
    const double pixel = kPointPitch / std::sin(elevation);
    double off = 0.0;
    for (const Eigen::Vector3d& p : outline) {
      CHECK(std::abs(p.z()) < 1e-9);
      CHECK(std::abs(p.head<2>().norm() - kLidRadius) < pixel);
      // Nearer to the eye, the wall below the edge faces it.
      CHECK(p.y() > -kLidRadius * kLidRadius / (kEyeDistance * std::cos(elevation)) - pixel);
      off += p.head<2>().norm() - kLidRadius;
    }
    CHECK(std::abs(off / static_cast<double>(outline.size())) < 0.25 * pixel);
  }
}

TEST_CASE(
    "where something nearer hides the edge, or nothing is seen beyond it, there is no outline",
    "[lid]") {
  const auto nearest_to = [](const Eigen::Vector3d& place_L, const SeenLid& seen) {
    double least = INFINITY;
    for (const Eigen::Vector3d& p : seen.outline()) least = std::min(least, (p - place_L).norm());
    return least;
  };
  const double elevation = 0.8, radius = 0.004;
  const Eigen::Vector3d edge = kLidRadius * Eigen::Vector3d(0.6, 0.8, 0.0);
  const Eigen::Vector3d eye =
      kEyeDistance * Eigen::Vector3d(0, -std::cos(elevation), std::sin(elevation));
  const Eigen::Vector3d before = edge + 0.1 * (eye - edge);
  const Patch ball = sphere(translation(before.x(), before.y(), before.z()), radius);
  CHECK(nearest_to(edge, SeenLid(elevation, {ground()})) < 0.003);
  const SeenLid hidden(elevation, {ground(), ball});
  CHECK(nearest_to(edge, hidden) > 0.003);
  CHECK(hidden.outline().size() > 10);
  CHECK(SeenLid(0.8).outline().empty());
}

TEST_CASE("a lid seen at a grazing angle, from below, or by few points has no outline",
          "[lid][degenerate]") {
  CHECK(SeenLid(0.1, {ground()}).outline().empty());
  CHECK(SeenLid(-0.8, {ground()}).outline().empty());
  SeenLid sparse(0.8, {ground()});
  std::vector<Eigen::Vector3d> few;
  for (std::size_t k = 0; k < sparse.points_C.size(); k += 100) few.push_back(sparse.points_C[k]);
  sparse.points_C = few;
  CHECK(sparse.outline().empty());
  sparse.points_C.clear();
  CHECK(sparse.outline().empty());
}
