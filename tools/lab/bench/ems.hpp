#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "lab/scoring/superquadric.hpp"

namespace quadrille::bench {

/// Settings of the fit of superquadrics.
struct EmsOptions {
  /// Share of points that are expected to be outliers.
  double outliers = 0.1;
  /// Number of points that are used; of more points, some at equal steps are taken.
  int max_points = 1000;
  /// Largest semi-axis, as a multiple of the largest distance of a point from the mean. A view from
  /// one side leaves a size open, which would grow without end.
  double max_axis = 2.0;
  /// Most rounds of expectation and maximisation from one start, and most switches.
  int max_rounds = 60, max_switches = 5;

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const;
};

/// A superquadric that was fitted to points.
struct EmsFit {
  scoring::Superquadric superquadric;
  /// Root of the mixture's variance, a third of the mean square radial distance of the inliers [m].
  double sigma = 0.0;
  /// Mean probability of the points to be inliers.
  double inliers = 0.0;
  /// Number of switches to a similar superquadric that turned out likelier.
  int switches = 0;
};

/// Fits a superquadric to the points of one object by expectation, maximisation and switching: Liu,
/// Wu, Ruan, Chirikjian, "Robust and Accurate Superquadric Recovery: a Probabilistic Approach",
/// CVPR 2022.
///
/// A point is an outlier, uniform over the box of all points, or normal about the surface. Rounds
/// alternate between the probabilities of the points to be inliers, and the superquadric and the
/// noise that explain these best; the superquadric by Levenberg-Marquardt steps on radial
/// distances. When nothing improves any more, each superquadric of much the same shape but with
/// other parameters (other axes in the role of z; a section turned by 45° with ε₂ → 2 − ε₂) is
/// tried as a start, and the likeliest result is kept. Deterministic.
/// @return nullopt if there are fewer points than the 11 parameters, or all lie about in a plane or
///   line, or one is not finite
std::optional<EmsFit> fit_superquadric(const std::vector<Eigen::Vector3f>& points,
                                       const EmsOptions& options = {});

}  // namespace quadrille::bench
