#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "fit/posed_quadric.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/quadric.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// The uncertainty that the samples of a surface leave about its quadric.
struct Uncertainty {
  /// Standard deviation of each canonical dimension [m], of angles [rad]; infinite if the samples
  /// do not show the dimension and its value is a guess.
  std::vector<double> std;
  QuadricCovariance covariance;
};

/// Variance V of the mean of a surface's noise, in the squared unit of its local coordinates. The
/// noise is averaged over the samples, over fewer where neighbours share it; see effective_share().
/// The points of a lid's outline may all be off together; that error is added without averaging.
double variance_of_mean(const Surface& surface);

/// Mean square of a surface's residuals less that of the measured noise, in the squared unit of its
/// local coordinates. Residuals are larger than the noise if it has waves longer than the patches
/// in which it is measured, if the depth image is bent or if the body has a flaw. At least a part
/// of what the sensor moves surfaces by, see uncertainty_of(), since a fit follows what bends. Zero
/// if neighbours do not share their noise.
double bend_variance(const Surface& surface);

/// Standard deviation of what the whole surface may be off along its normals, in the unit of its
/// local coordinates.
double offset_std(const Surface& surface, const SurfaceSamples& samples);

/// Derivative of a function of a posed quadric by a family's parameters, shapes and then motions,
/// by finite differences.
/// @param steps  the difference for each parameter
/// @param f      a step after which it has another size does not count
Eigen::MatrixXd derivative(const PosedQuadric& at, Family family, const Eigen::VectorXd& steps,
                           const std::function<Eigen::VectorXd(const PosedQuadric&)>& f);

/// Computes the covariance of a surface's fit, and from it, through the derivatives by the family's
/// parameters, that of q and of the dimensions. It has two parts. One is V (JᵀJ / N)⁻¹, where N is
/// the number of points and V their variance_of_mean(). The other is what a sensor that smooths its
/// image moves the whole surface along its normals by: the step −(JᵀJ)⁻¹ Jᵀ1 δ of the parameters.
/// The variance of δ is in proportion to the correlation of neighbours and to the square of the
/// cells' edge. Views count as independent.
/// @param form  canonical form of the surface's fit, in its local coordinates
Uncertainty uncertainty_of(const Surface& surface, const SurfaceSamples& samples,
                           const CanonicalForm& form);

}  // namespace quadrille
