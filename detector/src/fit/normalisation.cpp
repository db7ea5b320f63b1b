#include "fit/normalisation.hpp"

namespace quadrille {

Quadric Normalisation::to_frame(const Eigen::Matrix4d& Q_local) const {
  Eigen::Matrix4d S = Eigen::Matrix4d::Identity();
  S.topLeftCorner<3, 3>() /= scale;
  S.topRightCorner<3, 1>() = -centre / scale;
  return Quadric(Eigen::Matrix4d(S.transpose() * Q_local * S));
}

Eigen::Matrix4d Normalisation::to_local(const Quadric& Q) const {
  Eigen::Matrix4d S = Eigen::Matrix4d::Identity();
  S.topLeftCorner<3, 3>() *= scale;
  S.topRightCorner<3, 1>() = centre;
  return S.transpose() * Q.matrix() * S;
}

}  // namespace quadrille
