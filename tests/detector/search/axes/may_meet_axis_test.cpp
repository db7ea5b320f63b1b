#include "search/axes/may_meet_axis.hpp"

#include <algorithm>
#include <array>

#include "detector/search/axes/bottle.hpp"
#include "search/axes/normal_line.hpp"
#include "search/axes/point_runs.hpp"
#include "search/axes/set_flags.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr float kReach = 0.03f;

/// The samples near the axis whose normal lines meet it, one after the other.
std::vector<int> meeting(const SurfaceSamples& samples, const Eigen::Isometry3f& X_AC) {
  std::vector<int> list;
  for (int i = 0; i < samples.size(); ++i) {
    const NormalLine line(X_AC * samples.raw[i], X_AC.linear() * samples.n[i]);
    if (line.at.norm() <= kReach && line.has_direction() && line.meets_axis(samples.cell[i])) {
      list.push_back(i);
    }
  }
  return list;
}

}  // namespace

TEST_CASE("no sample whose normal line meets an axis nearby is left out, and few others are taken",
          "[search][axes]") {
  Eigen::Isometry3d X_CA = some_pose();
  const SurfaceSamples samples = bottle(X_CA, 0.0, 0.0);
  const PointRuns runs(samples.raw);
  for (const double off : {0.0, 0.004, 0.02}) {
    Eigen::Isometry3d moved = X_CA;
    moved.translation() += off * X_CA.linear().col(0);
    const Eigen::Vector3f point = moved.translation().cast<float>();
    const Eigen::Vector3f direction = moved.linear().col(2).cast<float>();
    std::vector<int> found;
    std::array<int, PointRuns::kLength> may, list;
    runs.for_each_near(point, direction, kReach, [&](int begin, int end) {
      may_meet_axis(samples, begin, end, point, direction, kReach, may.data());
      const int count = list_set_flags(may.data(), end - begin, list.data());
      for (int k = 0; k < count; ++k) found.push_back(begin + list[k]);
    });
    const std::vector<int> wanted = meeting(samples, moved.inverse().cast<float>());
    CHECK(std::is_sorted(found.begin(), found.end()));
    CHECK(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end()));
    CHECK(static_cast<double>(found.size()) <= 1.1 * static_cast<double>(wanted.size()) + 10.0);
  }
}
