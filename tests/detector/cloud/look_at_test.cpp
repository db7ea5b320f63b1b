#include "cloud/look_at.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3f;

namespace {

/// Points before, behind and beside a camera, at it, and missing ones.
std::vector<Vector3f> points_around(int count) {
  RandomStream random(7, 0);
  const auto coordinate = [&] { return static_cast<float>(4.0 * random.uniform() - 2.0); };
  std::vector<Vector3f> points;
  for (int k = 0; k < count; ++k) {
    const float x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
    if (k % 7 == 3) points.back().setZero();
    if (k % 11 == 5) points.back().setConstant(NAN);
    if (k % 13 == 8) points.back().z() = INFINITY;
  }
  return points;
}

}  // namespace

TEST_CASE("points are seen together as they are one by one", "[pinhole]") {
  PinholeView view;
  view.X_VC = Eigen::Translation3f(0.1f, -0.2f, 0.3f) *
              Eigen::AngleAxisf(0.7f, Vector3f(1, 2, 3).normalized());
  const std::vector<Vector3f> points = points_around(101);
  for (const int stride : {1, 2, 5}) {
    view.stride = stride;
    int seen = 0;
    for (std::size_t k = 0; k < view.looked_at(points.size()); k += SeenPoints::kSize) {
      const SeenPoints together = look_at(view, points, k);
      for (std::size_t i = 0; i < SeenPoints::kSize; ++i) {
        const std::size_t at = (k + i) * static_cast<std::size_t>(stride);
        const Vector3f alone = at < points.size() ? view(points[at]) : Vector3f::Zero();
        INFO("stride " << stride << ", point " << at);
        CHECK(Vector3f(together.u[i], together.v[i], together.w[i]) == alone);
        seen += alone.z() > 0.0f;
      }
    }
    CHECK(seen > 20 / stride);
  }
}

TEST_CASE("tangents and inverse depth are x/z, y/z and 1/z, within the field of view",
          "[pinhole]") {
  const float most = PinholeView::kMaxTangent;
  const std::vector<Vector3f> points = {{0.5f, -0.25f, 2.0f},
                                        {1.0f, 1.0f, -1.0f},
                                        {1.01f * most, 0.0f, 1.0f},
                                        {0.99f * most, 0.0f, 1.0f},
                                        {0.0f, 0.0f, 0.99f / PinholeView::kMaxInverseDepth},
                                        {0.0f, 0.0f, 1.01f / PinholeView::kMinInverseDepth}};
  const SeenPoints seen = look_at({}, points, 0);
  CHECK(seen.u[0] == 0.25f);
  CHECK(seen.v[0] == -0.125f);
  CHECK(seen.w[0] == 0.5f);
  CHECK(seen.u[3] == 0.99f * most);
  // The others lie behind the camera, beside its field of view, too near and too far; beyond the
  // last one there is none.
  CHECK(std::count(seen.w.begin(), seen.w.end(), 0.0f) == SeenPoints::kSize - 2);
}
