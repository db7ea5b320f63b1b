#include "boxes/upright_seeds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/quantile.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {
namespace {

// So many turns are tried through the quarter of a circle after which the sides are the same again,
// and then the best one is improved by steps half as large, and so on, down to a third of a degree.
constexpr int kTurns = 16;
constexpr int kHalvings = 4;
// About so many samples are compared at each turn, evenly chosen. With twice as many, boxes in
// simulated packed scenes are found no more often.
constexpr std::size_t kTried = 64;
// A side moves to the middle of the samples nearest to it, which then may be other ones, so often.
constexpr int kRounds = 3;
// At first a side lies where this share of the samples is behind it: the others may be strays.
constexpr double kOutermost = 0.95;
// Samples lie on a side within three standard deviations, but at least within this distance, by
// which packages bulge [m], and at most within this share of the thing's height: of a small round
// thing all samples are near the sides of some box.
constexpr double kMinReach = 0.0025;
constexpr double kMaxReach = 0.1;
// Least share of a piece's samples that lie on its sides; the others are on rounded edges.
constexpr double kMinShare = 0.9;

// The samples of a side end where its rounded edges begin. The side reaches little farther [m]: its
// plane also meets the table, in a line of points.
constexpr double kMargin = 0.5 * kRounding;

/// Three sides of a box that face the sensor: outward unit directions, and where the sides lie
/// along them [m].
struct Corner {
  Eigen::Matrix3d R_CS = Eigen::Matrix3d::Identity();
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  /// Sum of the squared distances of the samples from the nearest side, large ones cut [m²].
  double cost = 0.0;
};

class CornerFit {
 public:
  CornerFit(const SurfaceSamples& samples, std::span<const int> piece, const Eigen::Vector3d& up_C)
      : samples_(samples), piece_(piece), up_C_(up_C) {
    Eigen::Vector3d facing = Eigen::Vector3d::Zero();
    const std::size_t stride = 1 + piece.size() / kTried;
    for (std::size_t k = 0; k < piece.size(); k += stride) {
      places_.push_back(samples.raw[piece[k]].cast<double>());
      facing += samples.n[piece[k]].cast<double>();
    }
    reach_ = std::min(std::max(kMinReach, 3.0 * mean_sigma(samples, piece)), kMaxReach * height());
    facing -= facing.dot(up_C) * up_C;
    ahead_C_ = facing.norm() > 1e-6 ? facing.normalized() : up_C.unitOrthogonal();
  }

  Corner best() const {
    double step = 0.5 * std::numbers::pi / kTurns, turn = 0.0;
    Corner best = corner(turn);
    const auto try_turn = [&](double next) {
      const Corner other = corner(next);
      if (!(other.cost < best.cost)) return;
      best = other;
      turn = next;
    };
    for (int k = 1; k < kTurns; ++k) try_turn(k * step);
    for (int k = 0; k < kHalvings; ++k) {
      step *= 0.5;
      const double middle = turn;
      try_turn(middle - step);
      try_turn(middle + step);
    }
    return best;
  }

  /// The samples on each side.
  std::array<std::vector<int>, 3> on_sides(const Corner& corner) const {
    std::array<std::vector<int>, 3> on;
    for (const int i : piece_) {
      const auto [side, distance] = nearest(corner, samples_.raw[i].cast<double>());
      if (distance < reach_) on[side].push_back(i);
    }
    return on;
  }

 private:
  /// How high the thing is, but for strays [m].
  double height() const {
    std::vector<double> heights;
    heights.reserve(places_.size());
    for (const Eigen::Vector3d& p : places_) heights.push_back(up_C_.dot(p));
    const double lowest = quantile(heights, 1.0 - kOutermost);
    return quantile(heights, kOutermost) - lowest;
  }

  struct Nearest {
    int side;
    double distance;
  };
  static Nearest nearest(const Corner& corner, const Eigen::Vector3d& p_C) {
    Eigen::Index side = 0;
    const Eigen::Vector3d off = (corner.R_CS.transpose() * p_C - corner.at).cwiseAbs();
    const double distance = off.minCoeff(&side);
    return {static_cast<int>(side), distance};
  }

  /// The sides at a turn [rad], from that at which the first side is ahead to that at which the
  /// second one is: both level sides face the sensor.
  Corner corner(double turn) const {
    const Eigen::Vector3d right_C = up_C_.cross(ahead_C_);
    Corner corner;
    corner.R_CS.col(0) = std::cos(turn) * ahead_C_ + std::sin(turn) * right_C;
    corner.R_CS.col(1) = std::sin(turn) * ahead_C_ - std::cos(turn) * right_C;
    corner.R_CS.col(2) = up_C_;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> along;
      for (const Eigen::Vector3d& p : places_) along.push_back(corner.R_CS.col(axis).dot(p));
      corner.at[axis] = quantile(along, kOutermost);
    }
    for (int round = 0; round < kRounds; ++round) move_sides(&corner);
    for (const Eigen::Vector3d& p : places_) {
      const double distance = std::min(reach_, nearest(corner, p).distance);
      corner.cost += distance * distance;
    }
    return corner;
  }

  /// Moves each side to the middle of the samples that are nearest to it.
  void move_sides(Corner* corner) const {
    std::array<std::vector<double>, 3> along;
    for (const Eigen::Vector3d& p : places_) {
      const auto [side, distance] = nearest(*corner, p);
      if (distance < reach_) along[side].push_back(corner->R_CS.col(side).dot(p));
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (!along[axis].empty()) corner->at[axis] = median(along[axis]);
    }
  }

  const SurfaceSamples& samples_;
  std::span<const int> piece_;
  Eigen::Vector3d up_C_, ahead_C_;
  std::vector<Eigen::Vector3d> places_;
  double reach_ = 0.0;
};

}  // namespace

std::optional<BoxSeed> upright_seed(const SurfaceSamples& samples, std::span<const int> piece,
                                    const Eigen::Vector3d& up_C) {
  if (piece.size() < kMinSideSamples) return std::nullopt;
  const CornerFit fit(samples, piece, up_C);
  const Corner corner = fit.best();
  const std::array<std::vector<int>, 3> on = fit.on_sides(corner);
  std::size_t count = 0;
  BoxSeed seed;
  for (int axis = 0; axis < 3; ++axis) {
    count += on[axis].size();
    if (on[axis].size() < kMinSideSamples) continue;
    seed.push_back(patch_of_side(samples, on[axis], corner.R_CS, axis));
    seed.back().margin = kMargin;
  }
  if (static_cast<double>(count) < kMinShare * static_cast<double>(piece.size()))
    return std::nullopt;
  return seed.size() >= 2 ? std::optional(std::move(seed)) : std::nullopt;
}

}  // namespace quadrille
