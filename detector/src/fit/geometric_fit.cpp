#include "fit/geometric_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "fit/distance_sums.hpp"
#include "fit/family_spec.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// A fit stops if its predicted residual exceeds the wanted one by this factor, at its first step,
// its second, and the later ones, whose predictions are better. One in a hundred of the fits that
// would have reached it stops too.
constexpr std::array<double, 3> kMaxPromised = {10.0, 4.0, 3.0};
// A step is the last if it gained less than this many times the least worthwhile gain.
constexpr double kLastGain = 10.0;

using Normal = Matrix11d;

// There are at most ten parameters, so no memory is allocated on the heap.
using Tangent = Eigen::Matrix<double, 10, Eigen::Dynamic, 0, 10, 10>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 10, 10>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 10, 1>;

/// The derivative dD/dt = -(Gᵀ D + D G) of a quadric by a motion exp(t G) of its pose. The
/// generator G has a one in the last column for a translation, and a one and its opposite for a
/// rotation, so its products only pick rows and columns of D.
Eigen::Matrix4d derivative_by_motion(const Eigen::Matrix4d& D, int motion) {
  Eigen::Matrix4d rows = Eigen::Matrix4d::Zero(), columns = Eigen::Matrix4d::Zero();
  if (motion < 3) {
    rows.row(3) = D.row(motion);
    columns.col(3) = D.col(motion);
  } else {
    const int a = (motion - 3 + 1) % 3, b = (motion - 3 + 2) % 3;
    rows.row(a) = D.row(b), rows.row(b) = -D.row(a);
    columns.col(a) = D.col(b), columns.col(b) = -D.col(a);
  }
  return -(rows + columns);
}

/// The derivative dq/dθ of a family at a posed quadric: 10 x (shapes + motions).
Tangent tangent_space(const FamilySpec& spec, const PosedQuadric& q) {
  const Eigen::Matrix4d Y = q.X.inverse().matrix();
  Tangent T(10, static_cast<Eigen::Index>(spec.shapes.size() + spec.motions.size()));
  Eigen::Index column = 0;
  for (const auto& [i, j] : spec.shapes) {
    const Eigen::RowVector4d y_i = Y.row(i), y_j = Y.row(j);
    const auto at = [&, same = i == j](int r, int c) {
      return same ? y_i[r] * y_i[c] : y_j[r] * y_i[c] + y_i[r] * y_j[c];
    };
    T.col(column++) << at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(0, 2), at(1, 2), at(0, 3),
        at(1, 3), at(2, 3), at(3, 3);
  }
  for (const int motion : spec.motions) {
    const Eigen::Matrix4d dD = derivative_by_motion(q.D, motion);
    T.col(column++) = Quadric(Eigen::Matrix4d(Y.transpose() * dD * Y)).coefficients();
  }
  return T;
}

/// The Gauss-Newton equations A step = -b in a family's parameters.
struct Step {
  Square A;
  Vector b;

  Step(const FamilySpec& spec, const PosedQuadric& q, const Normal& N) {
    const Tangent T = tangent_space(spec, q);
    if (!project_any(T, N, std::integer_sequence<int, 3, 4, 5, 6, 7, 8, 10>())) {
      throw std::logic_error("no family has so many parameters");
    }
  }

  /// Calls project() for the number of parameters; returns false if it is none of these.
  template <int... n>
  bool project_any(const Tangent& T, const Normal& N, std::integer_sequence<int, n...>) {
    return ((T.cols() == n && (project<n>(T, N), true)) || ...);
  }

  /// Sets A and b. The number of parameters is known at compile time, so the loops are unrolled.
  template <int n>
  void project(const Tangent& tangent, const Normal& N) {
    const Eigen::Matrix<double, 10, n> T = tangent.leftCols<n>();
    const Eigen::Matrix<double, 10, n> NT = N.topLeftCorner<10, 10>().lazyProduct(T);
    A = T.transpose().lazyProduct(NT);
    b = T.transpose().lazyProduct(N.topRightCorner<10, 1>());
  }

  /// Solves the damped equations by their factors L D Lᵀ. The damping makes them positive definite,
  /// so the factors need no pivots. If rounding has made a pivot negative all the same, the step
  /// promises too little and ends the fit.
  Vector solve(double damping) const {
    const Eigen::Index n = b.size();
    Square L = A;
    L.diagonal().array() += damping * A.diagonal().array() + 1e-9 * A.diagonal().maxCoeff();
    Vector step = -b;
    for (Eigen::Index j = 0; j < n; ++j) {
      // Below the diagonal, column j holds L D so far, and is divided by D last.
      const double over = 1.0 / L(j, j);
      for (Eigen::Index k = j + 1; k < n; ++k) {
        const double factor = L(k, j) * over;
        for (Eigen::Index i = k; i < n; ++i) L(i, k) -= factor * L(i, j);
        step[k] -= factor * step[j];
      }
      for (Eigen::Index k = j + 1; k < n; ++k) L(k, j) *= over;
      step[j] *= over;
    }
    for (Eigen::Index j = n - 1; j > 0; --j) {
      for (Eigen::Index k = 0; k < j; ++k) step[k] -= L(j, k) * step[j];
    }
    return step;
  }
};

}  // namespace

PosedQuadric moved(Family family, PosedQuadric q, const Eigen::Ref<const Eigen::VectorXd>& step) {
  const FamilySpec& spec = family_spec(family);
  Eigen::Index k = 0;
  for (const auto& [i, j] : spec.shapes) {
    q.D(i, j) += step[k++];
    q.D(j, i) = q.D(i, j);
  }
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
  const Normal N = points->evaluate(start.matrix()).normal_equations();
  if (!N.allFinite()) return std::nullopt;
  fit.rss = N(10, 10);
  Step step(spec, fit.posed, N);
  double damping = 1e-3;  // Levenberg-Marquardt damping, relative to the diagonal
  for (int i = 0; i < iterations; ++i) {
    const Vector change = step.solve(damping);
    if (!change.allFinite()) break;
    const double gain = -step.b.dot(change);
    if (gain < min_gain * fit.rss) break;
    if (fit.rss - gain > kMaxPromised[std::min<std::size_t>(i, 2)] * wanted) break;
    const PosedQuadric next = moved(family, fit.posed, change);
    const double rss = points->evaluate(next.matrix()).squares();
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

StepEquations step_equations(DistanceSums<float>* points, Family family,
                             const PosedQuadric& quadric) {
  const Normal N = points->evaluate(quadric.matrix()).normal_equations();
  const Step step(family_spec(family), quadric, N);
  return {step.A, step.b, N(10, 10)};
}

FitInformation information(const OrientedPointsf& points, const FamilyFit& fit) {
  const Normal N = DistanceSums(points).evaluate(fit.posed.matrix()).offset_equations();
  const Step step(family_spec(fit.family), fit.posed, N);
  return {step.A, step.b};
}

}  // namespace quadrille
