#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "hand/oriented_box.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille::test {

/// Whether a box and a convex solid meet, in closed form and long double: no iteration, no
/// separating axes, nothing of FCL.
///
/// If they meet, an edge of the box meets the solid, or the solid lies in the box, or a face of the
/// box is pierced but none of its edges; then the section of the face's plane lies in the face, and
/// so does where the line between the solid's extreme points on either side of the plane crosses
/// it.
class ExactSolid {
 public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 3, 1>;

  explicit ExactSolid(const CollisionShape& shape) : shape_(shape) {
    for (const double d : shape.dimensions) size_.push_back(d);
    for (const Eigen::Vector3d& v : shape.vertices_S) vertices_.push_back(v.cast<Real>());
    add_faces();
  }

  /// True if p_C lies in the solid, to within about a nanometre: along an axis of its frame, of
  /// which one at least leaves each face steeply.
  bool contains(const Eigen::Vector3d& p_C) const {
    constexpr Real kSlack = 1e-9L;
    const Vector p = (shape_.X_CS.inverse() * p_C).cast<Real>();
    for (int i = 0; i < 3; ++i) {
      const auto [enter, leave] = clip(p, Vector::Unit(i));
      if (enter <= kSlack && leave >= -kSlack && enter <= leave + kSlack) return true;
    }
    return false;
  }

  bool meets(const OrientedBox& box) const {
    const Eigen::Matrix<Real, 3, 3> R_SC = shape_.X_CS.linear().cast<Real>().transpose();
    const Vector p = R_SC * (box.p_CB - shape_.X_CS.translation()).cast<Real>();
    const Eigen::Matrix<Real, 3, 3> R = R_SC * box.R_CB.cast<Real>();
    const Vector half = box.half.cast<Real>();
    const auto inside = [&](const Vector& x, int but) {
      const Vector x_B = R.transpose() * (x - p);
      for (int i = 0; i < 3; ++i) {
        if (i != but && std::abs(x_B[i]) > half[i]) return false;
      }
      return true;
    };
    if (inside(extreme(Vector::UnitX()), -1)) return true;
    for (int n = 0; n < 12; ++n) {
      const int along = n / 4, u = (along + 1) % 3, v = (along + 2) % 3;
      Vector start = p + (n & 1 ? half[u] : -half[u]) * R.col(u);
      start += (n & 2 ? half[v] : -half[v]) * R.col(v);
      const auto [enter, leave] = clip(start, R.col(along));
      if (enter <= leave && enter <= half[along] && leave >= -half[along]) return true;
    }
    for (int i = 0; i < 3; ++i) {
      const Vector high = extreme(R.col(i)), low = extreme(-R.col(i));
      const Real a = R.col(i).dot(low - p), b = R.col(i).dot(high - p);
      for (const Real d : {half[i], -half[i]}) {
        if (a > d || b < d || a == b) continue;
        if (inside(low + (d - a) / (b - a) * (high - low), i)) return true;
      }
    }
    return false;
  }

 private:
  using Interval = std::pair<Real, Real>;
  static constexpr Real kInfinite = std::numeric_limits<Real>::infinity();

  // Where p + t·d fulfils n·x ≤ h.
  static Interval below(const Vector& n, Real h, const Vector& p, const Vector& d) {
    const Real slope = n.dot(d), room = h - n.dot(p);
    if (slope == 0.0L) return room >= 0.0L ? Interval(-kInfinite, kInfinite) : Interval(1.0L, 0.0L);
    return slope > 0.0L ? Interval(-kInfinite, room / slope) : Interval(room / slope, kInfinite);
  }

  static Interval both(const Interval& a, const Interval& b) {
    return {std::max(a.first, b.first), std::min(a.second, b.second)};
  }

  static Interval slab(int axis, Real half, const Vector& p, const Vector& d) {
    const Vector n = Vector::Unit(axis);
    return both(below(n, half, p, d), below(-n, half, p, d));
  }

  // Where A t² + 2 B t + C ≤ 0 within an interval in which that set is connected.
  static Interval quadratic(Real A, Real B, Real C, const Interval& within) {
    if (A == 0.0L) {
      if (B == 0.0L) return C <= 0.0L ? within : Interval(1.0L, 0.0L);
      return both(within, B > 0.0L ? Interval(-kInfinite, -C / (2.0L * B))
                                   : Interval(-C / (2.0L * B), kInfinite));
    }
    const Real D = B * B - A * C;
    if (D < 0.0L) return A > 0.0L ? Interval(1.0L, 0.0L) : within;
    const Real q = -(B + std::copysign(std::sqrt(D), B));
    Real t0 = q / A, t1 = q == 0.0L ? t0 : C / q;
    if (t0 > t1) std::swap(t0, t1);
    if (A > 0.0L) return both(within, {t0, t1});
    const Interval low = both(within, {-kInfinite, t0}), high = both(within, {t1, kInfinite});
    return low.second - low.first > high.second - high.first ? low : high;
  }

  // The parameters at which p + t·d lies in the solid; first > second if none.
  Interval clip(const Vector& p, const Vector& d) const {
    const Interval all(-kInfinite, kInfinite);
    if (shape_.kind == "sphere" || shape_.kind == "ellipsoid") {
      const Vector s = semi_axes().cwiseInverse();
      const Vector q = s.cwiseProduct(p), e = s.cwiseProduct(d);
      return quadratic(e.dot(e), e.dot(q), q.dot(q) - 1.0L, all);
    }
    if (shape_.kind == "cylinder" || shape_.kind == "cone") {
      const Real half = 0.5L * size_[1];
      const Real k = shape_.kind == "cone" ? size_[0] / size_[1] : 0.0L;
      const Real r = shape_.kind == "cone" ? k * (half - p.z()) : size_[0], dr = -k * d.z();
      return quadratic(d.x() * d.x() + d.y() * d.y() - dr * dr,
                       d.x() * p.x() + d.y() * p.y() - dr * r,
                       p.x() * p.x() + p.y() * p.y() - r * r, slab(2, half, p, d));
    }
    Interval t = all;
    if (shape_.kind == "box") {
      for (int i = 0; i < 3; ++i) t = both(t, slab(i, 0.5L * size_[i], p, d));
      return t;
    }
    for (const auto& [n, h] : faces_) t = both(t, below(n, h, p, d));
    return t;
  }

  // The point of the solid farthest along n.
  Vector extreme(const Vector& n) const {
    const auto sign = [](Real x) { return x < 0.0L ? -1.0L : 1.0L; };
    if (shape_.kind == "sphere" || shape_.kind == "ellipsoid") {
      const Vector s = semi_axes();
      return s.cwiseProduct(s.cwiseProduct(n).normalized());
    }
    if (shape_.kind == "box") {
      Vector x;
      for (int i = 0; i < 3; ++i) x[i] = 0.5L * sign(n[i]) * size_[i];
      return x;
    }
    if (shape_.kind == "cylinder" || shape_.kind == "cone") {
      const Real across = std::hypot(n.x(), n.y()), half = 0.5L * size_[1];
      Vector x(size_[0], 0.0L, half * sign(n.z()));
      if (across > 0.0L) x.head<2>() = size_[0] / across * n.head<2>();
      if (shape_.kind == "cylinder") return x;
      x.z() = -half;
      const Vector apex(0.0L, 0.0L, half);
      return n.dot(apex) > n.dot(x) ? apex : x;
    }
    const auto less = [&](const Vector& a, const Vector& b) { return n.dot(a) < n.dot(b); };
    return *std::max_element(vertices_.begin(), vertices_.end(), less);
  }

  Vector semi_axes() const {
    if (shape_.kind == "sphere") return Vector::Constant(size_[0]);
    return {size_[0], size_[1], size_[2]};
  }

  void add_faces() {
    Vector middle = Vector::Zero();
    for (const Vector& v : vertices_) middle += v / static_cast<Real>(vertices_.size());
    for (std::size_t i = 0; i < shape_.faces.size(); i += shape_.faces[i] + 1) {
      const auto corner = [&](int k) { return vertices_[shape_.faces[i + 1 + k]]; };
      Vector n = (corner(1) - corner(0)).cross(corner(shape_.faces[i] / 2 + 1) - corner(0));
      if (n.norm() < 1e-18L) continue;
      n.normalize();
      if (n.dot(middle - corner(0)) > 0.0L) n = -n;
      faces_.emplace_back(n, n.dot(corner(0)));
    }
  }

  const CollisionShape& shape_;
  std::vector<Real> size_;
  std::vector<Vector> vertices_;
  std::vector<std::pair<Vector, Real>> faces_;
};

}  // namespace quadrille::test
