#include <cmath>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"
#include "view/depth_view.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kNear = 0.5, kFar = 0.8, kEdge = 0.02, kBaseline = 0.06;

// A plate before a wall, up to x = kEdge, as a sensor with a second eye at x = +eye sees it: what
// the plate hides from either is missing; so is what missing(u, v) asks for.
template <class Missing>
PointCloud plate_and_wall(double eye, Missing&& missing) {
  PointCloud cloud;
  cloud.width = kWidth;
  cloud.height = kHeight;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray = pixel_ray(u, v);
      const bool near = kNear * ray.x() < kEdge;
      const Eigen::Vector3d p = (near ? kNear : kFar) * ray;
      // Where the line from the second eye to p passes the plate's depth.
      const double crossing = eye + (p.x() - eye) * kNear / kFar;
      const bool lost = missing(u, v) || (!near && eye != 0.0 && crossing < kEdge);
      cloud.points.push_back(lost ? Eigen::Vector3f::Constant(std::nanf(""))
                                  : Eigen::Vector3f(p.cast<float>()));
    }
  }
  return cloud;
}

bool nothing(int, int) { return false; }

}  // namespace

TEST_CASE("beside an edge space is free up to the second eye's line of sight",
          "[occupancy][gaps]") {
  const PointCloud cloud = plate_and_wall(-kBaseline, nothing);
  const DepthView blind(cloud), seeing(cloud, kBaseline);
  int freed = 0;
  std::mt19937 random(31);
  for (int n = 0; n < 4000; ++n) {
    const Eigen::Vector3d p(uniform(random, 0.0, 0.08), uniform(random, -0.05, 0.05),
                            uniform(random, 0.4, 0.75));
    const bool free = seeing.sees_past(p, 0.001);
    CHECK(free >= blind.sees_past(p, 0.001));
    freed += free && !blind.sees_past(p, 0.001);
    if (!free || p.z() < kNear) continue;
    // Both eyes see it: the lines from both pass beside the plate, to within a pixel's width.
    const double pixel = 1.5 * p.z() / kFocal;
    CHECK(p.x() * kNear / p.z() > kEdge - pixel);
    CHECK(-kBaseline + (p.x() + kBaseline) * kNear / p.z() > kEdge - pixel);
  }
  CHECK(freed > 100);
}

TEST_CASE("a gap wider than the baseline explains stays unknown", "[occupancy][gaps]") {
  const PointCloud cloud = plate_and_wall(-kBaseline, nothing);
  const DepthView narrow(cloud, 0.25 * kBaseline);
  const Eigen::Vector3d inside_gap(0.028, 0.0, 0.45);
  CHECK_FALSE(narrow.sees_past(inside_gap, 0.001));
  CHECK(DepthView(cloud, kBaseline).sees_past(inside_gap, 0.001));
}

TEST_CASE("a narrow gap is free as far as nothing that counts fits into it", "[occupancy][gaps]") {
  // Of a gap's pixels two at either end take their neighbours' depth: 10 to 14 remain.
  constexpr int kGap = 14, kTaken = 4;
  const auto hole = [](int u, int v) {
    return u >= 200 && u < 200 + kGap && v >= 100 && v < 100 + 40;
  };
  const PointCloud cloud = plate_and_wall(0.0, hole);
  const double thin = 0.02;
  const DepthView view(cloud, 0.0, thin);
  const Eigen::Vector3d ray = pixel_ray(207, 120);
  CHECK_FALSE(DepthView(cloud).sees_past(0.3 * ray, 0.001));
  CHECK(view.sees_past((thin * kFocal / kGap - 0.01) * ray, 0.001));
  CHECK_FALSE(view.sees_past((thin * kFocal / (kGap - kTaken) + 0.01) * ray, 0.001));
}
