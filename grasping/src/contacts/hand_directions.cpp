#include "contacts/hand_directions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "contacts/directions.hpp"
#include "quadrille/detector/vector_clones.hpp"

namespace quadrille {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// Level closing directions are tried every 15°, approaches around a closing direction every 30°.
constexpr int kLevelDirections = 12, kApproaches = 12;
// Directions that differ by less than this count as the same: somewhat less than the steps above.
const double kSameDirection = std::cos(13.0 * kDegree);
// So many main directions of the normals are sought, among so many normals of them. A normal within
// an angle of 25° belongs to a main direction, since surfaces bend.
constexpr std::size_t kMainDirections = 4, kSeeds = 60;
const double kAlike = std::cos(25.0 * kDegree);
// Fewer normals may be noise.
constexpr std::size_t kMinNormals = 8;
// Least sine between two directions of which one gives a direction across the other.
constexpr double kMinAcross = 0.1, kMinSteep = 0.5;

/// Directions, coordinate by coordinate.
struct DirectionList {
  std::vector<double> x, y, z;

  explicit DirectionList(const std::vector<Eigen::Vector3d>& directions) {
    for (const Eigen::Vector3d& d : directions) {
      x.push_back(d.x()), y.push_back(d.y()), z.push_back(d.z());
    }
  }
};

/// Counts the directions whose cosine with one of them is larger than `least`.
QUADRILLE_VECTOR_CLONES
std::size_t count_alike(const DirectionList& directions, const Eigen::Vector3d& one, double least) {
  // Unlike vectors, these do not check each access.
  const double *x = directions.x.data(), *y = directions.y.data(), *z = directions.z.data();
  const double one_x = one.x(), one_y = one.y(), one_z = one.z();
  std::int64_t alike = 0;
  for (std::size_t n = 0; n < directions.x.size(); ++n) {
    // The order of the sum is that of Eigen's product.
    alike += static_cast<std::int64_t>(x[n] * one_x + (y[n] * one_y + z[n] * one_z) > least);
  }
  return static_cast<std::size_t>(alike);
}

/// Returns the mean of the directions whose cosine with one of them is larger than `least`.
Eigen::Vector3d mean_alike(const std::vector<Eigen::Vector3d>& directions,
                           const Eigen::Vector3d& one, double least) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& d : directions) {
    if (d.dot(one) > least) sum += d;
  }
  return sum.normalized();
}

/// Returns the directions that most normals share, the most common one first.
std::vector<Eigen::Vector3d> main_directions(std::vector<Eigen::Vector3d> normals) {
  std::vector<Eigen::Vector3d> main;
  while (main.size() < kMainDirections && normals.size() >= kMinNormals) {
    const DirectionList list(normals);
    std::size_t most = 0, best_seed = 0;
    for (std::size_t i = 0; i < normals.size(); i += normals.size() / kSeeds + 1) {
      const std::size_t alike = count_alike(list, normals[i], kSameDirection);
      if (alike > most) most = alike, best_seed = i;
    }
    const Eigen::Vector3d best = most > 0 ? mean_alike(normals, normals[best_seed], kSameDirection)
                                          : Eigen::Vector3d::Zero();
    main.push_back(best);
    std::erase_if(normals, [&](const Eigen::Vector3d& n) { return n.dot(best) > kAlike; });
  }
  return main;
}

std::vector<Eigen::Vector3d> closings(std::vector<Eigen::Vector3d> normals,
                                      const ApproachSpace& space) {
  std::vector<Eigen::Vector3d> all;
  const auto add = [&](const Eigen::Vector3d& d) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const Eigen::Vector3d& other) {
      return std::abs(other.dot(d)) > kSameDirection;
    });
    if (!known) all.push_back(d);
  };
  for (const Eigen::Vector3d& n : main_directions(std::move(normals))) add(n);
  const Eigen::Vector3d about = space.up_C.isZero() ? space.view_C : space.up_C;
  const Eigen::Vector3d across = about.cross(space.view_C);
  if (across.norm() > kMinAcross) add(across.normalized());
  for (int axis = 0; axis < 3; ++axis) add(space.axes_C.col(axis));
  for (const Eigen::Vector3d& d : level_directions(about, kLevelDirections)) add(d);
  return all;
}

/// Returns the steepest approach for a closing direction; for a steep closing direction, the one
/// nearest to the line of sight.
Eigen::Vector3d first_approach(const Eigen::Vector3d& closing, const ApproachSpace& space) {
  Eigen::Vector3d first = -space.up_C;
  if (first.cross(closing).norm() < kMinSteep) first = -space.view_C;
  if (first.cross(closing).norm() < kMinAcross) first = closing.unitOrthogonal();
  return (first - closing * closing.dot(first)).normalized();
}

}  // namespace

std::vector<Eigen::Matrix3d> hand_directions(std::vector<Eigen::Vector3d> normals_C,
                                             const ApproachSpace& space) {
  std::vector<Eigen::Matrix3d> directions;
  for (const Eigen::Vector3d& closing : closings(std::move(normals_C), space)) {
    const Eigen::Vector3d first = first_approach(closing, space);
    for (const Eigen::Vector3d& approach :
         fan(first, closing.cross(first), kApproaches, 2.0 * std::numbers::pi)) {
      if (!reachable(approach, space) || !wanted(approach, space)) continue;
      directions.emplace_back();
      directions.back() << closing.cross(approach), closing, approach;
    }
  }
  return directions;
}

}  // namespace quadrille
