#include "contacts/finger_slices.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "quadrille/grasping/gripper.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

constexpr SliceHeights kHeights{0.04f, 0.05f};
// Points so near to a limit of a slice may be in it or not, by rounding [m].
constexpr double kDoubt = 1e-6;

/// Points of a target within 40 mm of the origin, and of other things around it.
struct Crowd {
  std::vector<Eigen::Vector3d> points;
  std::vector<char> own;

  explicit Crowd(std::mt19937& random) {
    std::uniform_real_distribution<double> own_at(-0.04, 0.04), other_at(-0.3, 0.3);
    for (int n = 0; n < 2000; ++n) {
      own.push_back(n % 5 == 0 ? 1 : 0);
      auto& at = own.back() ? own_at : other_at;
      points.emplace_back(at(random), at(random), at(random));
    }
  }
};

}  // namespace

TEST_CASE("a slice holds the points that a finger covers near the highest own one",
          "[contacts][points]") {
  std::mt19937 random(6);
  std::normal_distribution<double> any;
  const Gripper gripper = franka_hand();
  const double width = gripper.finger.x();
  for (int round = 0; round < 5; ++round) {
    const Crowd crowd(random);
    FingerSlices slices(crowd.points, crowd.own, gripper, kHeights);
    Eigen::Matrix3d R = Eigen::Quaterniond(any(random), any(random), any(random), any(random))
                            .normalized()
                            .toRotationMatrix();
    // Other approaches with the same closing direction use what was sorted along that.
    for (int turn = 0; turn < round % 3; ++turn) {
      slices.cut(R);
      slices.cut(R * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()).toRotationMatrix());
      R = R * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()).toRotationMatrix();
    }
    const std::vector<FingerSlice>& cut = slices.cut(R);
    REQUIRE(cut.size() > 5);
    const SortedPoints sorted = slices.sorted();
    for (const FingerSlice& slice : cut) {
      std::set<std::size_t> held;
      float last_y = -1.0f;
      for (const std::uint32_t k : slice.points) {
        held.insert(sorted.index[k]);
        CHECK(sorted.y[k] >= last_y);
        last_y = sorted.y[k];
      }
      double low = 1.0, high = -1.0, top = 1.0;
      const auto beside = [&](std::size_t i) {
        return std::abs(R.col(0).dot(crowd.points[i]) - slice.x);
      };
      for (std::size_t i = 0; i < crowd.points.size(); ++i) {
        if (!crowd.own[i] || beside(i) > 0.5 * width) continue;
        const double y = R.col(1).dot(crowd.points[i]);
        low = std::min(low, y), high = std::max(high, y);
        top = std::min(top, R.col(2).dot(crowd.points[i]));
      }
      CHECK(slice.top == Approx(top).margin(kDoubt));
      const double reach = gripper.max_opening + gripper.finger.y();
      for (std::size_t i = 0; i < crowd.points.size(); ++i) {
        const double y = R.col(1).dot(crowd.points[i]), z = R.col(2).dot(crowd.points[i]);
        const double inside =
            std::min({0.5 * width - beside(i), z - top + kHeights.above, top + kHeights.below - z,
                      y - low + reach, high + reach - y});
        if (inside > kDoubt) CHECK(held.contains(i));
        // Somewhat more may be held along the closing direction.
        if (inside < -2e-4) CHECK_FALSE(held.contains(i));
      }
    }
  }
}
