#include "fit/geometric_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "fit/family_spec.hpp"
#include "fit/normal_equations.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// A fit stops if its predicted residual exceeds the wanted one by this factor.
constexpr double kMaxPromised = 4.0;
// A step is the last if it gained less than this many times the least worthwhile gain.
constexpr double kLastGain = 10.0;

using Normal = Matrix11d;

/// The generator of a motion as a 4x4 matrix of se(3).
Eigen::Matrix4d generator(int motion) {
  Eigen::Matrix4d G = Eigen::Matrix4d::Zero();
  if (motion < 3) {
    G(motion, 3) = 1.0;
  } else {
    const int a = (motion - 3 + 1) % 3, b = (motion - 3 + 2) % 3;
    G(b, a) = 1.0;
    G(a, b) = -1.0;
  }
  return G;
}

// There are at most ten parameters, so no memory is allocated on the heap.
using Tangent = Eigen::Matrix<double, 10, Eigen::Dynamic, 0, 10, 10>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 10, 10>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 10, 1>;

/// The derivative dq/dθ of a family at a posed quadric: 10 x (shapes + motions).
Tangent tangent_space(const FamilySpec& spec, const PosedQuadric& q) {
  const Eigen::Matrix4d Y = q.X.inverse().matrix();
  Tangent T(10, static_cast<Eigen::Index>(spec.shapes.size() + spec.motions.size()));
  Eigen::Index column = 0;
  for (const Eigen::Matrix4d& shape : spec.shapes) {
    T.col(column++) = Quadric(Eigen::Matrix4d(Y.transpose() * shape * Y)).coefficients();
  }
  for (const int motion : spec.motions) {
    const Eigen::Matrix4d G = generator(motion);
    const Eigen::Matrix4d dD = -(G.transpose() * q.D + q.D * G);
    T.col(column++) = Quadric(Eigen::Matrix4d(Y.transpose() * dD * Y)).coefficients();
  }
  return T;
}

/// The Gauss-Newton equations A step = -b in a family's parameters.
struct Step {
  Tangent T;
  Square A;
  Vector b;

  Step(const FamilySpec& spec, const PosedQuadric& q, const Normal& N)
      : T(tangent_space(spec, q)),
        A(T.transpose().lazyProduct(Tangent(N.topLeftCorner<10, 10>().lazyProduct(T)))),
        b(T.transpose().lazyProduct(N.topRightCorner<10, 1>())) {}

  Vector solve(double damping) const {
    Square damped = A;
    damped.diagonal().array() += damping * A.diagonal().array() + 1e-9 * A.diagonal().maxCoeff();
    return -damped.ldlt().solve(b);
  }
};

}  // namespace

PosedQuadric moved(Family family, PosedQuadric q, const Eigen::Ref<const Eigen::VectorXd>& step) {
  const FamilySpec& spec = family_spec(family);
  Eigen::Index k = 0;
  for (const Eigen::Matrix4d& shape : spec.shapes) q.D += step[k++] * shape;
  Eigen::Vector3d t = Eigen::Vector3d::Zero(), r = Eigen::Vector3d::Zero();
  for (const int motion : spec.motions) (motion < 3 ? t[motion] : r[motion - 3]) = step[k++];
  Eigen::Isometry3d dX = Eigen::Isometry3d::Identity();
  if (r.norm() > 0) dX.linear() = Eigen::AngleAxisd(r.norm(), r.normalized()).toRotationMatrix();
  dX.translation() = t;
  q.X = q.X * dX;
  // Only the general family has a free scale; the others keep a coefficient fixed.
  if (spec.motions.empty()) q.D /= q.D.norm();
  return q;
}

template <typename Scalar>
std::optional<FamilyFit> refine(DistanceSums<Scalar>* points, Family family,
                                const PosedQuadric& start, int iterations, double wanted,
                                double min_gain) {
  const FamilySpec& spec = family_spec(family);
  if (points->points() < spec.dof) return std::nullopt;
  FamilyFit fit;
  fit.family = family;
  fit.posed = start;
  fit.points = static_cast<int>(points->points());
  points->evaluate(start.matrix());
  const Normal N = points->normal_equations();
  if (!N.allFinite()) return std::nullopt;
  fit.rss = N(10, 10);
  Step step(spec, fit.posed, N);
  double damping = 1e-3;  // Levenberg-Marquardt damping, relative to the diagonal
  for (int i = 0; i < iterations; ++i) {
    const Vector change = step.solve(damping);
    if (!change.allFinite()) break;
    const double gain = -step.b.dot(change);
    if (gain < min_gain * fit.rss) break;
    if (i > 0 && fit.rss - gain > kMaxPromised * wanted) break;
    const PosedQuadric next = moved(family, fit.posed, change);
    points->evaluate(next.matrix());
    const double rss = points->squares();
    if (rss < fit.rss) {
      const bool converged = rss > (1.0 - kLastGain * min_gain) * fit.rss;
      fit.posed = next;
      fit.rss = rss;
      if (converged || i + 1 == iterations) break;
      step = Step(spec, fit.posed, points->normal_equations());
      damping *= 0.1;
    } else {
      damping *= 10.0;
      if (damping > 1e3) break;
    }
  }
  return fit;
}

template std::optional<FamilyFit> refine(DistanceSums<float>*, Family, const PosedQuadric&, int,
                                         double, double);
template std::optional<FamilyFit> refine(DistanceSums<double>*, Family, const PosedQuadric&, int,
                                         double, double);

Eigen::MatrixXd information(const OrientedPointsf& points, const FamilyFit& fit) {
  const Normal N = normal_equations(points, fit.posed.matrix());
  return Step(family_spec(fit.family), fit.posed, N).A;
}

}  // namespace quadrille
