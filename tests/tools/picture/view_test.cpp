#include "picture/view.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("from above the floor fills the view and a ball is round", "[picture]") {
  PointCloud cloud;
  for (int i = -60; i <= 60; ++i) {
    for (int j = -60; j <= 60; ++j) cloud.points.push_back({0.01f * i, 0.2f, 1.0f + 0.01f * j});
  }
  ViewSubject subject;
  subject.planes_C = {{Eigen::Vector3d(0, -1, 0), 1000}, {Eigen::Vector3d(0, 0, -1), 9000}};
  const View top = fit_view(cloud, 640, ViewSide::kTop, subject);
  // Up is away from the floor: its normal comes towards the eye.
  CHECK((top.X_VC.linear() * Eigen::Vector3d(0, -1, 0)).isApprox(Eigen::Vector3d(0, 0, -1), 1e-6));
  // What is far from the camera is at the top.
  CHECK(top.project({0, 0.2, 1.4})->y() < top.project({0, 0.2, 0.6})->y());
  CHECK(top.project({0.4, 0.2, 1})->x() > top.project({-0.4, 0.2, 1})->x());
  const View side = fit_view(cloud, 640, ViewSide::kSide, subject);
  // Seen from the right: what is far is on the right, what is high above.
  CHECK(side.project({0, 0.2, 1.4})->x() > side.project({0, 0.2, 0.6})->x());
  CHECK(side.project({0, 0.0, 1.0})->y() < side.project({0, 0.2, 1.0})->y());
}

TEST_CASE("a cloud all around its viewpoint is seen from outside", "[picture]") {
  PointCloud cloud;
  for (int i = -10; i <= 10; ++i) {
    for (int j = -10; j <= 10; ++j) {
      for (const float side : {-1.0f, 1.0f}) cloud.points.push_back({0.1f * i, 0.1f * j, side});
    }
  }
  const View view = fit_view(cloud, 400);
  for (const Eigen::Vector3f& p : cloud.points) {
    const auto at = view.project(p.cast<double>());
    REQUIRE(at.has_value());
    CHECK(at->x() > -20);
    CHECK(at->x() < 420);
  }
}
