#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lab/experiments/experiment.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::experiments {

/// A sphere that is known to be there.
struct KnownSphere {
  Eigen::Vector3d centre_C;
  double radius;
};

/// What was found of it, in shares of the radius; nothing if it was not found.
struct SphereError {
  bool found = false;
  /// Found radius over the true one, minus 1.
  double radius = 0.0;
  /// Distance of the centres over the radius.
  double centre = 0.0;
};

/// The sphere (or ellipsoid, with its mean semi-axis) whose centre is within a radius of the true
/// one, the nearest of them.
SphereError match(const DetectionResult& result, const KnownSphere& truth);

/// Quantiles and distributions of the errors, by group.
Report report_errors(const std::map<std::string, std::vector<SphereError>>& groups);

}  // namespace quadrille::experiments
