#include "search/sphere_vote.hpp"

#include <cmath>

namespace quadrille {

Eigen::Matrix4d tangent_sphere(const OrientedPoint& point, double curvature) {
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q.diagonal().head<3>().setConstant(0.5 * curvature);
  const Eigen::Vector3d b = 0.5 * (point.n - curvature * point.x);
  Q.topRightCorner<3, 1>() = b;
  Q.bottomLeftCorner<1, 3>() = b.transpose();
  Q(3, 3) = 0.5 * curvature * point.x.squaredNorm() - point.n.dot(point.x);
  return Q;
}

std::vector<VotePeak> vote_curvature(const OrientedPoint& basis, const OrientedPointsf& voters,
                                     const VoteOptions& options) {
  const Eigen::Vector3f p = basis.x.cast<float>(), n = basis.n.cast<float>();
  const Eigen::ArrayXf dx = voters.x() - p.x(), dy = voters.y() - p.y(), dz = voters.z() - p.z();
  const Eigen::ArrayXf square = dx.square() + dy.square() + dz.square();
  const Eigen::ArrayXf curvature = -2.0f * (n.x() * dx + n.y() * dy + n.z() * dz) / square;
  // The gradient ∇f = n + κ d has length one on the sphere.
  const Eigen::ArrayXf cosine = (n.x() + curvature * dx) * voters.nx() +
                                (n.y() + curvature * dy) * voters.ny() +
                                (n.z() + curvature * dz) * voters.nz();
  const float min_square = static_cast<float>(options.min_height * options.min_height);
  VoteHistogram histogram(options);
  for (Eigen::Index i = 0; i < voters.size(); ++i) {
    if (square[i] > min_square && cosine[i] > options.min_cosine) histogram.add(curvature[i]);
  }
  return histogram.peaks();
}

}  // namespace quadrille
