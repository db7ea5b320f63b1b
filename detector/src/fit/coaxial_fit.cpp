#include "fit/coaxial_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "fit/family_spec.hpp"
#include "fit/geometric_fit.hpp"

namespace quadrille {
namespace {

// The first unknowns are those of the axis: translations along x and y, rotations about x and y.
constexpr Eigen::Index kAxis = 4;
// A step that promises a smaller share of the sum of squares is not taken.
constexpr double kMinGain = 1e-5;
// Share of the largest diagonal element that is added to all, so that unknowns on which nothing
// depends do no harm.
constexpr double kRidge = 1e-12;
// Largest Levenberg-Marquardt damping, relative to the diagonal, before the fit ends.
constexpr double kMaxDamping = 1e3;

constexpr int kTx = 0, kTy = 1, kTz = 2, kRx = 3, kRy = 4;

bool moves(const FamilySpec& spec, int motion) {
  return std::find(spec.motions.begin(), spec.motions.end(), motion) != spec.motions.end();
}

/// Number of unknowns of a part's profile: its shapes, and its height if the family has one.
std::size_t profile_size(Family family) {
  const FamilySpec& spec = family_spec(family);
  return spec.shapes.size() + (moves(spec, kTz) ? 1 : 0);
}

/// Returns which unknown of its profile a part shares with another one to which it is parallel; the
/// only shape of a cone is its slope, and the centre of a sphere comes after its shape. Parallel
/// cylinders share nothing but the axis.
std::optional<std::size_t> shared_by_parallels(Family family) {
  if (family == Family::kCone) return 0;
  if (family == Family::kSphere) return 1;
  return std::nullopt;
}

/// A part about the axis: its canonical matrix in the unit of its local coordinates, and the height
/// of its canonical frame's origin on the axis [m].
struct Profile {
  Eigen::Matrix4d D;
  double height;
};

/// All unknowns of the joint fit.
struct State {
  Eigen::Isometry3d X_CA;
  std::vector<Profile> profiles;
};

PosedQuadric posed(const State& state, std::size_t i, const CoaxialPart& part) {
  const Profile& profile = state.profiles[i];
  PosedQuadric result;
  result.D = profile.D;
  result.X.linear() = state.X_CA.linear();
  result.X.translation() =
      (state.X_CA * Eigen::Vector3d(0.0, 0.0, profile.height) - part.local.centre) /
      part.local.scale;
  return result;
}

/// The joint fit's equations and what they are made of.
struct Equations {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
  double rss = 0.0;
  CoaxialFit fit;
};

/// The equations of a joint fit.
class JointFit {
 public:
  explicit JointFit(std::span<const CoaxialPart> parts) : parts_(parts), size_(kAxis) {
    for (const CoaxialPart& part : parts) {
      std::vector<Eigen::Index> columns(profile_size(part.fit.family));
      const auto shared =
          part.parallel_to ? shared_by_parallels(part.fit.family) : std::optional<std::size_t>();
      for (std::size_t k = 0; k < columns.size(); ++k) {
        columns[k] = k == shared ? columns_[*part.parallel_to][k] : size_++;
      }
      columns_.push_back(std::move(columns));
    }
  }

  /// Places all parts on the axis of the one with the most points. A part turns about the middle of
  /// its points, so that it stays near them.
  State start() const {
    const CoaxialPart& main = *std::max_element(
        parts_.begin(), parts_.end(),
        [](const CoaxialPart& a, const CoaxialPart& b) { return a.fit.points < b.fit.points; });
    State state;
    state.X_CA.linear() = main.fit.posed.X.linear();
    state.X_CA.translation() = middle_C(main);
    const Eigen::Vector3d z_C = state.X_CA.linear().col(2);
    for (const CoaxialPart& part : parts_) {
      const Eigen::Isometry3d& X = part.fit.posed.X;
      Profile profile{part.fit.posed.D, 0.0};
      Eigen::Vector3d own_z_C = X.linear().col(2);
      if (own_z_C.dot(z_C) < 0.0) {
        // Half a turn about x.
        const Eigen::Vector4d turn(1.0, -1.0, -1.0, 1.0);
        profile.D = turn.asDiagonal() * profile.D * turn.asDiagonal();
        own_z_C = -own_z_C;
      }
      profile.height = z_C.dot(middle_C(part) - state.X_CA.translation());
      if (part.fit.family != Family::kSphere) {
        profile.height += part.local.scale * own_z_C.dot(X.translation());
      }
      state.profiles.push_back(profile);
    }
    return state;
  }

  Equations equations(const State& state) const {
    Equations all;
    all.A = Eigen::MatrixXd::Zero(size_, size_);
    all.b = Eigen::VectorXd::Zero(size_);
    all.fit.X_CA = state.X_CA;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const CoaxialPart& part = parts_[i];
      FamilyFit fit = part.fit;
      fit.posed = posed(state, i, part);
      const StepEquations own = step_equations(part.points, fit.family, fit.posed);
      const Eigen::MatrixXd M = map(state, i);
      const double square = square_of(part);
      Eigen::MatrixXd H = square * M.transpose() * own.A * M;
      all.A += H;
      all.b += square * M.transpose() * own.b;
      all.rss += square * own.rss;
      fit.rss = own.rss;
      all.fit.parts.push_back(std::move(fit));
      all.fit.information.push_back(std::move(H));
      all.fit.map.push_back(M);
    }
    return all;
  }

  /// The weighted sum of squares alone.
  double rss(const State& state) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const CoaxialPart& part = parts_[i];
      sum += square_of(part) * part.points->evaluate(posed(state, i, part).matrix()).squares();
    }
    return sum;
  }

  /// The state after a step.
  State moved_by(const State& state, const Eigen::VectorXd& step) const {
    State next;
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    const Eigen::Vector3d r(step[2], step[3], 0.0);
    if (r.norm() > 0.0) {
      motion.linear() = Eigen::AngleAxisd(r.norm(), r.normalized()).toRotationMatrix();
    }
    motion.translation() << step[0], step[1], 0.0;
    next.X_CA = state.X_CA * motion;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const FamilySpec& spec = family_spec(parts_[i].fit.family);
      Profile profile = state.profiles[i];
      std::size_t k = 0;
      for (const auto& [row, column] : spec.shapes) {
        profile.D(row, column) += step[columns_[i][k++]];
        profile.D(column, row) = profile.D(row, column);
      }
      if (moves(spec, kTz)) profile.height += step[columns_[i][k]];
      next.profiles.push_back(profile);
    }
    return next;
  }

 private:
  /// The weight of a squared distance in a part's local coordinates.
  static double square_of(const CoaxialPart& part) {
    return part.weight * part.local.scale * part.local.scale;
  }

  /// A point of a part's axis in the middle of its points, whose centroid is the origin of the
  /// local coordinates. Through the centre of a sphere runs any axis.
  static Eigen::Vector3d middle_C(const CoaxialPart& part) {
    const Eigen::Isometry3d& X = part.fit.posed.X;
    if (part.fit.family == Family::kSphere) {
      return part.local.centre + part.local.scale * X.translation();
    }
    const Eigen::Vector3d z = X.linear().col(2);
    const Eigen::Vector3d middle = X.translation() - z.dot(X.translation()) * z;
    return part.local.centre + part.local.scale * middle;
  }

  /// The map from a step of the joint fit to one in a part's parameters.
  Eigen::MatrixXd map(const State& state, std::size_t i) const {
    const CoaxialPart& part = parts_[i];
    const FamilySpec& spec = family_spec(part.fit.family);
    const auto shapes = static_cast<Eigen::Index>(spec.shapes.size());
    const double height = state.profiles[i].height;
    const double scale = part.local.scale;
    Eigen::MatrixXd M =
        Eigen::MatrixXd::Zero(shapes + static_cast<Eigen::Index>(spec.motions.size()), size_);
    for (Eigen::Index k = 0; k < shapes; ++k) M(k, columns_[i][k]) = 1.0;
    Eigen::Index row = shapes;
    for (const int motion : spec.motions) {
      switch (motion) {
        case kTx:
          M(row, 0) = 1.0 / scale;
          M(row, 3) = height / scale;
          break;
        case kTy:
          M(row, 1) = 1.0 / scale;
          M(row, 2) = -height / scale;
          break;
        case kTz:
          M(row, columns_[i][shapes]) = 1.0 / scale;
          break;
        case kRx:
          M(row, 2) = 1.0;
          break;
        case kRy:
          M(row, 3) = 1.0;
          break;
        default:
          break;
      }
      ++row;
    }
    return M;
  }

  std::span<const CoaxialPart> parts_;
  /// For each part the unknowns of its profile.
  std::vector<std::vector<Eigen::Index>> columns_;
  Eigen::Index size_;
};

/// Solves the damped equations.
Eigen::VectorXd solve(const Equations& equations, double damping) {
  Eigen::MatrixXd A = equations.A;
  A.diagonal().array() +=
      damping * equations.A.diagonal().array() + kRidge * equations.A.diagonal().maxCoeff();
  return -A.ldlt().solve(equations.b);
}

}  // namespace

bool has_one_axis(Family family) {
  switch (family) {
    case Family::kCylinder:
    case Family::kCone:
    case Family::kParaboloid:
    case Family::kRevolution:
      return true;
    default:
      return false;
  }
}

std::optional<CoaxialFit> fit_coaxial(std::span<const CoaxialPart> parts, int iterations) {
  const JointFit joint(parts);
  State state = joint.start();
  Equations equations = joint.equations(state);
  double damping = 1e-3;
  for (int i = 0; i < iterations; ++i) {
    if (!equations.A.allFinite() || !equations.b.allFinite()) return std::nullopt;
    const Eigen::VectorXd step = solve(equations, damping);
    if (!step.allFinite()) return std::nullopt;
    if (-equations.b.dot(step) < kMinGain * equations.rss) break;
    State next = joint.moved_by(state, step);
    if (joint.rss(next) < equations.rss) {
      state = std::move(next);
      equations = joint.equations(state);
      damping *= 0.1;
    } else {
      damping *= 10.0;
      if (damping > kMaxDamping) break;
    }
  }
  if (!equations.A.allFinite()) return std::nullopt;
  return std::move(equations.fit);
}

CoaxialCovariance covariance_of(const CoaxialFit& fit, std::span<const double> variances) {
  const Eigen::Index size = fit.information.front().rows();
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size), S = H;
  for (std::size_t i = 0; i < fit.information.size(); ++i) {
    H += fit.information[i];
    S += variances[i] * fit.information[i];
  }
  // Spheres about one centre leave the direction of the axis open, on which they do not depend.
  H.diagonal().array() += kRidge * H.diagonal().maxCoeff();
  const Eigen::LDLT<Eigen::MatrixXd> factors(H);
  const Eigen::MatrixXd half = factors.solve(S);
  return {factors.solve(Eigen::MatrixXd(half.transpose())), fit.map};
}

}  // namespace quadrille
