#include "lab/physics/exact_detection.hpp"

#include "quadrille/detector/quadric.hpp"

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;

// Rounding error of a quadric that is written relative to a camera a metre away.
constexpr double kRounding = 1e-6;

Eigen::AlignedBox3d moved(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& X) {
  Eigen::AlignedBox3d result;
  for (int i = 0; i < 8; ++i) {
    result.extend(X * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  }
  return result;
}

Detection whole(int id) {
  Detection d;
  d.id = id;
  d.score = 1.0;
  d.seen = 1.0;
  return d;
}

}  // namespace

Detection exact_quadric(int id, const Quadric& Q_C, const Eigen::Isometry3d& X_CS,
                        const Eigen::AlignedBox3d& box_S) {
  Detection d = whole(id);
  // The quadric is expressed in its own frame and unit, in which rounding errors are negligible.
  const double unit = 0.5 * box_S.sizes().maxCoeff();
  Vector10d q = Q_C.transformed(X_CS.inverse()).coefficients();
  if (q[0] < 0.0) q = -q;
  d.Q_C = Quadric(q).transformed(X_CS).normalized();
  q.head<6>() *= unit * unit;
  q.segment<3>(6) *= unit;
  q /= q.cwiseAbs().maxCoeff();
  const CanonicalForm form = canonical_form(Quadric(q), kRounding);
  Eigen::Isometry3d X_SQ = form.X;
  X_SQ.translation() *= unit;
  d.type = form.type;
  d.X_CQ = X_CS * X_SQ;
  d.extent_Q = moved(box_S, X_SQ.inverse());
  for (const auto& [name, value] : form.dimensions) {
    d.dimensions.push_back({name, is_angle(name) ? value : value * unit, 0.0});
  }
  if (d.type == QuadricType::kCylinder || d.type == QuadricType::kEllipticCylinder) {
    d.dimensions.push_back({"length", d.extent_Q.sizes().z(), 0.0});
  }
  return d;
}

Detection exact_plane(int id, const Eigen::Isometry3d& X_CS, const Eigen::AlignedBox3d& box_S) {
  Detection d = whole(id);
  d.type = QuadricType::kPlane;
  d.X_CQ = X_CS;
  if (d.X_CQ.linear().col(2).dot(d.X_CQ.translation()) > 0.0) {
    d.X_CQ.linear().rightCols<2>() *= -1.0;
  }
  d.extent_Q = moved(box_S, d.X_CQ.inverse() * X_CS);
  const Vector3d n_C = d.X_CQ.linear().col(2);
  Vector10d q = Vector10d::Zero();
  q.segment<3>(6) = 0.5 * n_C;
  q[9] = -n_C.dot(d.X_CQ.translation());
  d.Q_C = Quadric(q).normalized();
  d.dimensions = {{"width", d.extent_Q.sizes().x(), 0.0}, {"height", d.extent_Q.sizes().y(), 0.0}};
  return d;
}

}  // namespace quadrille::physics
