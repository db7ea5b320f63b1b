#include "boxes/box_seeds.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "base/quantile.hpp"
#include "boxes/upright_seeds.hpp"
#include "samples/convex_pieces.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {
namespace {

// A piece of fewer samples may be noise, or points mixed from two surfaces.
constexpr std::size_t kMinSamples = 40;
// A sample belongs to a side if its normal is within this angle of the side's [rad]: faces bulge.
constexpr double kMaxTilt = 0.5;
// Least share of a piece's samples that belong to a side. Of the mantle of a cylinder only .64 do;
// with a lid they may be more, and then its sides are refused because they bend.
constexpr double kMinShare = 0.7;
// The sides and the axes are found in turn, so often. After two rounds one of 176 boxes in
// simulated scenes still changes, by .2 mm; ten rounds change nothing.
constexpr int kRounds = 5;
// So many normals are tried for the first axis, evenly chosen: a side that has a tenth of the
// samples has six of them.
constexpr std::size_t kTried = 64;
// A normal counts for the turn about the first axis if it is more than this far from it, as the
// squared sine of the angle.
constexpr double kMinAcross = 0.5;

// At most so many pieces are looked at, so that clutter takes no more time than boxes.
constexpr int kMaxPieces = 16;
// A thing stands on a plane if this share of its samples lies above it: a few may be strays.
constexpr double kMinAbove = 0.95;

/// For each axis the side that faces the sensor, and its samples: of two opposite sides a view
/// shows one.
struct Side {
  double sign = 1.0;
  std::vector<int> samples;
};
using Sides = std::array<Side, 3>;

/// The direction in which most normals point: the mean of those about the normal that has the most
/// neighbours.
Eigen::Vector3d main_normal(const SurfaceSamples& samples, const std::vector<int>& piece) {
  const auto least = static_cast<float>(std::cos(0.5 * kMaxTilt));
  const std::size_t stride = 1 + piece.size() / kTried;
  int most = 0;
  Eigen::Vector3f best = samples.n[piece.front()];
  for (std::size_t k = 0; k < piece.size(); k += stride) {
    int about = 0;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const int i : piece) {
      if (samples.n[i].dot(samples.n[piece[k]]) < least) continue;
      ++about;
      sum += samples.n[i];
    }
    if (about > most) {
      most = about;
      best = sum;
    }
  }
  return best.cast<double>().normalized();
}

/// Axes of which the first is given. They are turned about it so that the other normals are nearest
/// to them: four times an angle is the same for all four directions of two axes.
Eigen::Matrix3d axes_about(const SurfaceSamples& samples, const std::vector<int>& piece,
                           const Eigen::Vector3d& first) {
  const Eigen::Vector3d e1 = first.unitOrthogonal(), e2 = first.cross(e1);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const int i : piece) {
    const Eigen::Vector3d n = samples.n[i].cast<double>();
    const Eigen::Vector2d across(n.dot(e1), n.dot(e2));
    if (across.squaredNorm() < kMinAcross) continue;
    const double angle = 4.0 * std::atan2(across.y(), across.x());
    sum += across.squaredNorm() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  const double turn = 0.25 * std::atan2(sum.y(), sum.x());
  Eigen::Matrix3d R;
  R.col(0) = first;
  R.col(1) = std::cos(turn) * e1 + std::sin(turn) * e2;
  R.col(2) = R.col(0).cross(R.col(1));
  return R;
}

Sides sides_of(const SurfaceSamples& samples, const std::vector<int>& piece,
               const Eigen::Matrix3d& R) {
  std::array<std::array<std::vector<int>, 2>, 3> all;
  for (const int i : piece) {
    const Eigen::Vector3d n = R.transpose() * samples.n[i].cast<double>();
    Eigen::Index axis = 0;
    if (n.cwiseAbs().maxCoeff(&axis) > std::cos(kMaxTilt)) all[axis][n[axis] > 0.0].push_back(i);
  }
  Sides sides;
  for (int axis = 0; axis < 3; ++axis) {
    const bool up = all[axis][1].size() > all[axis][0].size();
    sides[axis] = {up ? 1.0 : -1.0, std::move(all[axis][up])};
  }
  return sides;
}

/// The right-angled axes that are nearest to the normals of the sides (the polar factor of their
/// sums).
Eigen::Matrix3d axes_of(const SurfaceSamples& samples, const Sides& sides,
                        const Eigen::Matrix3d& R) {
  // An axis whose side is not seen follows from the others.
  Eigen::Matrix3d S = 1e-3 * R;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int i : sides[axis].samples) {
      S.col(axis) += sides[axis].sign * samples.n[i].cast<double>();
    }
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(S, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d turned = svd.matrixU() * svd.matrixV().transpose();
  return turned.determinant() > 0.0 ? turned : R;
}

std::optional<BoxSeed> seed_of(const SurfaceSamples& samples, const std::vector<int>& piece) {
  Eigen::Matrix3d R = axes_about(samples, piece, main_normal(samples, piece));
  Sides sides = sides_of(samples, piece, R);
  for (int round = 0; round < kRounds; ++round) {
    R = axes_of(samples, sides, R);
    sides = sides_of(samples, piece, R);
  }
  std::size_t on_sides = 0;
  BoxSeed seed;
  for (int axis = 0; axis < 3; ++axis) {
    on_sides += sides[axis].samples.size();
    if (sides[axis].samples.size() < kMinSideSamples) continue;
    Eigen::Matrix3d R_CA = R;
    R_CA.col(axis) *= sides[axis].sign;
    seed.push_back(patch_of_side(samples, sides[axis].samples, R_CA, axis));
  }
  const bool is_box = static_cast<double>(on_sides) > kMinShare * static_cast<double>(piece.size());
  return is_box && seed.size() >= 2 ? std::optional(std::move(seed)) : std::nullopt;
}

/// The normal of the plane on which a piece stands: of those below all of it but strays, the
/// nearest, if the piece is no farther above it than it is high. Its foot may be hidden.
std::optional<Eigen::Vector3d> up_of(const SurfaceSamples& samples, const std::vector<int>& piece,
                                     std::span<const Eigen::Hyperplane<double, 3>> floors) {
  std::optional<Eigen::Vector3d> up_C;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Hyperplane<double, 3>& floor : floors) {
    std::vector<double> heights;
    heights.reserve(piece.size());
    for (const int i : piece) {
      heights.push_back(floor.signedDistance(samples.raw[i].cast<double>()));
    }
    const double lowest = quantile(heights, 1.0 - kMinAbove),
                 highest = quantile(heights, kMinAbove);
    if (lowest < -kRounding || lowest > highest - lowest || !(lowest < nearest)) continue;
    nearest = lowest;
    up_C = floor.normal();
  }
  return up_C;
}

}  // namespace

FlatPatch patch_of_side(const SurfaceSamples& samples, std::span<const int> side,
                        const Eigen::Matrix3d& R_CA, int axis) {
  std::vector<Eigen::Vector3d> points_C;
  for (const int i : side) points_C.push_back(samples.raw[i].cast<double>());
  Eigen::Matrix3d R_CL;
  R_CL.col(2) = R_CA.col(axis);
  R_CL.col(0) = R_CA.col((axis + 1) % 3);
  R_CL.col(1) = R_CL.col(2).cross(R_CL.col(0));
  return {patch_around(points_C, R_CL), mean_sigma(samples, side)};
}

std::vector<BoxSeed> find_box_seeds(const SurfaceSamples& samples, const Mask& free,
                                    std::span<const Eigen::Hyperplane<double, 3>> floors) {
  std::vector<BoxSeed> seeds;
  int pieces = 0;
  const auto add = [&](std::optional<BoxSeed> seed) {
    if (seed) seeds.push_back(std::move(*seed));
  };
  for (const std::vector<int>& connected : connected_pieces(samples, free)) {
    if (connected.size() < kMinSamples) break;
    for (const std::vector<int>& piece : convex_pieces(samples, connected)) {
      if (piece.size() < kMinSamples) break;
      if (++pieces > kMaxPieces) return seeds;
      add(seed_of(samples, piece));
      if (const auto up_C = up_of(samples, piece, floors)) add(upright_seed(samples, piece, *up_C));
    }
  }
  return seeds;
}

}  // namespace quadrille
