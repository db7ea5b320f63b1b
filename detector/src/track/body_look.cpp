#include "track/body_look.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace quadrille {
namespace {

// Least side of a body's box: the sizes of flat things are mostly noise [m].
constexpr double kLeastSide = 0.01;
// Standard deviation of a body's middle, as a share of its size: it moves by as much as a quarter
// when the hidden half of a body is told in one cloud and not in the next.
constexpr double kMiddleShare = 0.1;
// Share of the newest look in what is remembered. With more, a body that is joined with its
// neighbour in one cloud is often taken for the neighbour in the next one; from .3 to .5 the bodies
// of simulated kitchens keep their numbers about equally well.
constexpr double kNewestShare = 0.4;

}  // namespace

BodyLook look_of(const SceneBody& body, const Eigen::Isometry3d& X_WC) {
  BodyLook look;
  look.middle_W = X_WC * body.X_CB.translation();
  const Eigen::Matrix3d R_WB = X_WC.linear() * body.X_CB.linear();
  // The variance along a side whose points are spread evenly.
  const Eigen::Vector3d variances = body.size.cwiseMax(kLeastSide).cwiseAbs2() / 12.0;
  look.spread_W = R_WB * variances.asDiagonal() * R_WB.transpose();
  return look;
}

double place_std(const BodyLook& look) {
  return kMiddleShare * std::sqrt(12.0 * look.spread_W.trace() / 3.0);
}

BodyLook translated(BodyLook look, const Eigen::Vector3d& shift_W) {
  look.middle_W += shift_W;
  return look;
}

BodyLook renewed(const BodyLook& before, const BodyLook& now) {
  return {before.middle_W + kNewestShare * (now.middle_W - before.middle_W),
          before.spread_W + kNewestShare * (now.spread_W - before.spread_W)};
}

LookMatch match_looks(const BodyLook& from, const BodyLook& to, const Expectation& expected) {
  const Eigen::Vector3d shift_W = to.middle_W - from.middle_W;
  const Eigen::Matrix3d mean = 0.5 * (from.spread_W + to.spread_W);
  const Eigen::Matrix3d around = mean + expected.motion_variance * Eigen::Matrix3d::Identity();
  const double place = shift_W.dot(around.ldlt().solve(shift_W));
  if (!(place < expected.gate * expected.gate)) return {};
  const double shapes = 4.0 * std::log(mean.determinant() / std::sqrt(from.spread_W.determinant() *
                                                                      to.spread_W.determinant()));
  const double cost = place + shapes - 2.0 * std::log(expected.seen_share);
  return std::isfinite(cost) ? LookMatch{shift_W, cost} : LookMatch{};
}

}  // namespace quadrille
