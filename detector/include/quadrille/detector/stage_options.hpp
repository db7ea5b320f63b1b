#pragma once

#include <vector>

#include "quadrille/detector/family.hpp"

namespace quadrille {

/// How the noise of the sensor is measured.
struct NoiseOptions {
  /// Radius of the patches [m]. Smaller windows would follow the waves of a sensor's correlated
  /// noise and see too little of them.
  double radius = 0.04;
  /// Of all patches' residuals this quantile is taken: clutter is no quadratic.
  double quantile = 0.25;
  /// Patches to look at, about.
  int patches = 400;
};

/// How the points are averaged.
struct SamplingOptions {
  /// Edge of the finest cells [m], at the depth of the nearer third of the points: about a tenth
  /// of the smallest object.
  double cell = 0.0031;
  /// Noise of a finest cell's mean, in cells, above which the cells are doubled: smaller ones
  /// would show the noise and not the surface.
  double noisiest_cell = 0.8;
  /// Takes every so many-th point of a depth image.
  int stride = 1;
  NoiseOptions noise;
};

/// What counts as a plane.
struct PlaneOptions {
  /// Samples that a plane has at least.
  int min_samples = 40;
  /// Largest distance, in multiples of the samples' sigma.
  double sigmas = 3.0;
  /// Largest angle between the normals of sample and plane [rad].
  double angle = 0.26;
  /// A region whose quadratic fit bends with a smaller radius [m], significantly, is no plane.
  double min_radius = 0.7;
  /// Nor is one that might bend with a smaller radius than this [m], for all that its noise lets
  /// one say.
  double min_proven_radius = 0.3;
};

/// When a sample lies on a quadric.
struct InlierTest {
  /// Largest distance in multiples of a sample's sigma, plus a share of its cell.
  double sigmas = 3.0, cells = 0.1;
  /// Least |cosine| between normal and gradient; -1 to ignore normals.
  double min_cosine = 0.9;
};

/// How hypotheses are drawn from a neighbourhood.
enum class BasisKind {
  kThreePoints,  ///< three oriented points and a vote along their null space (paper, section 4)
  kFourPoints,   ///< a fourth point fixes λ (paper, theorem 3)
  kNinePoints,   ///< nine points without normals
  kTwoPoints,    ///< two oriented points and a vote in three dimensions (paper, figure 2b)
  kSphere,       ///< one oriented point and a vote for the radius (paper, figure 2b)
};

/// How a vote's parameter λ in (−∞, ∞) is carried to a bounded place for its bin (paper,
/// "Quantizing λ").
enum class Quantisation {
  kArctangent,  ///< atan(λ / λ₀), the angle that the paper's footnote names
  kMeasured,    ///< the inverse of the measured distribution of λ: bins of equal mass
};

/// How far and how often a hypothesis is grown.
struct GrowOptions {
  /// Families that a refit chooses from; a single one is fitted without a choice.
  std::vector<Family> families = {Family::kPlane, Family::kSphere, Family::kCylinder, Family::kCone,
                                  Family::kRevolution};
  /// Samples that a candidate has at least.
  int min_samples = 25;
  /// Rounds of growing and refitting.
  int rounds = 5;
  /// Points that a fit uses at most.
  int fit_points = 128;
};

/// Where hypotheses are looked for, and how many.
struct SearchOptions {
  /// How hypotheses are drawn.
  BasisKind basis = BasisKind::kThreePoints;
  Quantisation quantisation = Quantisation::kArctangent;
  /// Radii of the neighbourhoods that bases are drawn from, in cells.
  std::vector<double> radii = {5.0, 9.0, 15.0};
  /// Bases per seed and radius.
  int bases = 5;
  /// Voters per basis at most.
  int voters = 100;
  /// Whether a basis of three points is voted on only once (paper, section 5).
  bool hash_triplets = false;
  /// Share of a neighbourhood that a hypothesis must explain.
  double min_support = 0.5;
  GrowOptions grow;
};

/// Thresholds of the paper's clustering of hypotheses ("Hypotheses aggregation").
struct AgglomerateOptions {
  /// Whether to cluster before the aggregation chooses among the candidates.
  bool enabled = false;
  /// τ: largest ‖q₁ − q₂‖₁ of unit coefficients in coordinates of the region.
  double max_difference = 0.4;
  /// Largest d_close of one cluster.
  double max_close = 0.4;
  /// Largest d_far of one cluster.
  double max_far = 0.3;
};

/// When a surface is accepted, and how it is fitted.
struct AggregateOptions {
  /// Families that a surface's fit chooses from, beside the general one.
  std::vector<Family> families = {
      Family::kPlane,      Family::kSphere,     Family::kCylinder,         Family::kCone,
      Family::kRevolution, Family::kParaboloid, Family::kEllipticCylinder, Family::kParabolic};
  /// Share of a candidate's samples that no better one has claimed.
  double min_open = 0.5;
  /// Samples of a surface at least, and of a plane that was not found before.
  int min_samples = 30, min_plane_samples = 60;
  /// Least confidence of a curved surface; see evidence.hpp.
  double min_confidence = 0.45;
  /// Largest rms of a curved surface, in multiples of the noise: real objects are quadrics only
  /// nearly.
  double max_residual = 100.0;
  /// Least spread of the normals of a curved surface [rad]: less is a plane, or anything.
  double min_spread = 0.4;
  /// Least confidence for candidates of the coarser levels, which claim their samples before the
  /// finer ones are searched, and their largest rms in multiples of the noise.
  double min_confidence_early = 0.8, max_residual_early = 1.3;
  /// Largest rms of a plane that stands in for such a surface, in multiples of the noise.
  double max_residual_plane = 2.0;
  /// Points that a fit uses at most.
  int fit_points = 240;
  /// Independent measurements at most, per sample and in all. Sensor noise comes in waves, and real
  /// objects are quadrics only nearly: more samples than this argue for no richer type.
  double effective_share = 0.0625, effective_size = 40.0;
  /// Factor on the distance within which an accepted quadric claims further samples.
  double claim = 1.3;
};

}  // namespace quadrille
