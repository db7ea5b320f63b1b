#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/setting.hpp"

namespace quadrille {

// Each struct's visit() calls v(field, Setting) for each of its options in the order of the
// configuration file; the Setting describes the field.

/// Measurement of the sensor's noise.
struct NoiseOptions {
  double radius = 0.04;
  double quantile = 0.25;
  int patches = 400;

  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.radius, {"sampling.noise.radius", "m", 1e-4, 10.0,
                 "Radius of the patches. Smaller windows would follow the waves of a sensor's "
                 "correlated noise and see too little of them."});
    v(o.quantile, {"sampling.noise.quantile", "", 0.0, 1.0,
                   "Of all patches' residuals this quantile is taken: clutter is no quadratic."});
    v(o.patches, {"sampling.noise.patches", "", 1, 1e6, "Patches to look at, about."});
  }
};

/// Averaging of the points.
struct SamplingOptions {
  double cell = 0.0031;
  double relative_cell = 0.0;
  int max_cells = 80'000;
  double noisiest_cell = 0.8;
  int stride = 1;
  NoiseOptions noise;

  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.cell, {"sampling.cell", "m", 1e-5, 10.0,
               "Edge of the finest cells, at the depth of the nearer third of the points: about a "
               "tenth of the smallest object."});
    v(o.relative_cell, {"sampling.relative_cell", "", 0.0, 1.0,
                        "The paper's τ_s: the same as a share of the diagonal of the cloud's "
                        "bounding box, in place of sampling.cell; 0 for that. The paper has 0.025 "
                        "to 0.05."});
    v(o.max_cells, {"sampling.max_cells", "", 100, 1e8,
                    "A depth image has about this many of the finest cells at most; those of a far "
                    "scene in a large image become larger. Time grows with their number, and "
                    "smaller cells have too few points to average out their noise."});
    v(o.noisiest_cell, {"sampling.noisiest_cell", "", 0.01, 100.0,
                        "Noise of a finest cell's mean, in cells, above which the cells are "
                        "doubled: smaller ones would show the noise and not the surface."});
    v(o.stride, {"sampling.stride", "", 1, 100, "Takes every so many-th point of a depth image."});
    NoiseOptions::visit(o.noise, v);
  }
};

/// Criteria of a plane.
struct PlaneOptions {
  int min_samples = 40;
  double sigmas = 3.0;
  double angle = 0.26;
  double min_radius = 0.7;
  double min_proven_radius = 0.3;

  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.min_samples, {"planes.min_samples", "", 4, 1e6, "Samples that a plane has at least."});
    v(o.sigmas,
      {"planes.sigmas", "", 0.1, 100.0, "Largest distance, in multiples of the samples' sigma."});
    v(o.angle, {"planes.angle", "rad", 0.01, std::numbers::pi / 2.0,
                "Largest angle between the normals of sample and plane."});
    v(o.min_radius, {"planes.min_radius", "m", 1e-6, 1e6,
                     "A region whose quadratic fit bends with a smaller radius, significantly, is "
                     "no plane."});
    v(o.min_proven_radius, {"planes.min_proven_radius", "m", 1e-6, 1e6,
                            "Nor is one that might bend with a smaller radius than this, for all "
                            "that its noise lets one say."});
  }
};

/// Criteria by which a sample lies on a quadric.
struct InlierTest {
  double sigmas = 3.0;
  double cells = 0.2;
  double min_cosine = 0.9;

  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.sigmas, {"inlier.sigmas", "", 0.1, 100.0,
                 "Largest distance in multiples of a sample's sigma, plus inlier.cells."});
    v(o.cells, {"inlier.cells", "", 0.0, 10.0, "Share of its cell that is added to that."});
    v(o.min_cosine, {"inlier.min_cosine", "", -1.0, 1.0,
                     "Least |cosine| between normal and gradient; -1 to ignore normals."});
  }
};

/// How well the poses of several views of one scene are known, and how long they are remembered.
struct ViewOptions {
  double shift = 0.002;
  double turn = 0.0035;
  double remember = 60.0;
  double sector = 0.26;
  int most = 8;

  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.shift, {"views.shift", "m", 0.0, 0.1,
                "Standard deviation of the position of a further view's camera, as the robot knows "
                "it. Views are brought onto each other within it; 0 trusts the poses."});
    v(o.turn, {"views.turn", "rad", 0.0, 0.1,
               "Standard deviation of the direction of that camera; 0 trusts the poses."});
    v(o.remember, {"views.remember", "s", 0.0, 1e6,
                   "How long a view from elsewhere is remembered while the camera moves; 0: each "
                   "cloud stands alone. What is forgotten is unknown."});
    v(o.sector, {"views.sector", "rad", 0.01, 3.2,
                 "Angle between the directions of sight of two views that are both remembered."});
    v(o.most,
      {"views.most", "", 1, 64,
       "Largest number of views that are remembered. Each takes the memory of a small cloud "
       "and some ten milliseconds of each plan; a deadline leaves out the oldest."});
  }
};

/// Ways to draw hypotheses from a neighbourhood.
enum class BasisKind {
  kThreePoints,  ///< three oriented points and a vote along their null space (paper, section 4)
  kSphere,       ///< one oriented point and a vote for the radius (paper, figure 2b)
};

constexpr auto words_of(BasisKind) {
  return std::to_array<Word<BasisKind>>(
      {{"three_points", BasisKind::kThreePoints}, {"sphere", BasisKind::kSphere}});
}

/// Growing of a hypothesis.
struct GrowOptions {
  std::vector<Family> families = {Family::kPlane, Family::kSphere, Family::kCylinder, Family::kCone,
                                  Family::kRevolution};
  int min_samples = 25;
  int rounds = 12;
  int fit_points = 128;

  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.families, {"search.grow.families",
                   "Families that a refit chooses from; a single one is fitted without a choice."});
    v(o.min_samples,
      {"search.grow.min_samples", "", 9, 1e6, "Samples that a candidate has at least."});
    v(o.rounds, {"search.grow.rounds", "", 0, 1000,
                 "Rounds of growing and refitting; 0 keeps a hypothesis as it was drawn."});
    v(o.fit_points, {"search.grow.fit_points", "", 16, 1e6, "Points that a fit uses at most."});
  }
};

/// Search for hypotheses.
struct SearchOptions {
  BasisKind basis = BasisKind::kThreePoints;
  std::vector<double> radii = {5.0, 9.0, 15.0};
  int bases = 5;
  int voters = 100;
  double min_support = 0.5;
  int axes = 30;
  GrowOptions grow;

  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.basis, {"search.basis", "How hypotheses are drawn."});
    v(o.radii, {"search.radii", "", 0.5, 1000.0,
                "Radii of the neighbourhoods that bases are drawn from, in cells, ascending."});
    v(o.bases, {"search.bases", "", 1, 10000, "Bases per seed and radius."});
    v(o.voters, {"search.voters", "", 16, 100000, "Voters per basis at most."});
    v(o.min_support, {"search.min_support", "", 0.0, 1.0,
                      "Share of a neighbourhood that a hypothesis must explain."});
    v(o.axes, {"search.axes", "", 0, 10000,
               "Axes at most, square to the largest plane, for which normal lines vote and about "
               "which surfaces are sought without random bases. Later they are sought about the "
               "axes of accepted surfaces too; 0 for neither."});
    GrowOptions::visit(o.grow, v);
  }
};

/// Acceptance of surfaces and their final fit.
struct AggregateOptions {
  std::vector<Family> families = {
      Family::kPlane,      Family::kSphere,     Family::kCylinder,         Family::kCone,
      Family::kRevolution, Family::kParaboloid, Family::kEllipticCylinder, Family::kParabolic};
  double min_open = 0.5;
  int min_samples = 30;
  int min_plane_samples = 60;
  double min_first_look = 0.05;
  double min_confidence = 0.6;
  double min_plane_confidence = 0.5;
  double min_confidence_early = 0.8;
  double max_residual_early = 1.3;
  double max_residual = 100.0;
  double min_spread = 0.4;
  double max_residual_plane = 2.0;
  int fit_points = 240;
  double effective_share = 0.0625;
  double effective_size = 40.0;
  double claim = 1.3;

  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.families, {"aggregate.families",
                   "Families that a surface's fit chooses from, beside the general one."});
    v(o.min_open, {"aggregate.min_open", "", 0.0, 1.0,
                   "Share of a candidate's samples that no better one has claimed."});
    v(o.min_samples, {"aggregate.min_samples", "", 9, 1e6, "Samples of a surface at least."});
    v(o.min_plane_samples, {"aggregate.min_plane_samples", "", 9, 1e6,
                            "Samples at least of a plane that was not found before."});
    v(o.min_first_look, {"aggregate.min_first_look", "", 0.0, 1.0,
                         "Least confidence in a candidate as the search found it, before it gets a "
                         "better fit, which raises the confidence of many to twice and more."});
    v(o.min_confidence, {"aggregate.min_confidence", "", 0.0, 1.0,
                         "Least confidence of a curved surface, from the evidence for it."});
    v(o.min_plane_confidence, {"aggregate.min_plane_confidence", "", 0.0, 1.0,
                               "Least confidence of a plane that was not found before."});
    v(o.min_confidence_early, {"aggregate.min_confidence_early", "", 0.0, 1.0,
                               "The same for candidates of the coarser levels, which claim their "
                               "samples before the finer ones are searched."});
    v(o.max_residual_early, {"aggregate.max_residual_early", "", 0.0, 100.0,
                             "Largest rms of such a candidate, in multiples of the noise."});
    v(o.max_residual, {"aggregate.max_residual", "", 0.0, 1000.0,
                       "Largest rms of a curved surface, in multiples of the noise: real objects "
                       "are quadrics only nearly."});
    v(o.min_spread, {"aggregate.min_spread", "rad", 0.0, std::numbers::pi,
                     "Least spread of the normals of a curved surface: less is a plane, or "
                     "anything."});
    v(o.max_residual_plane, {"aggregate.max_residual_plane", "", 0.0, 100.0,
                             "Largest rms of a plane that stands in for such a surface, in "
                             "multiples of the noise."});
    v(o.fit_points, {"aggregate.fit_points", "", 16, 1e6, "Points that a fit uses at most."});
    v(o.effective_share, {"aggregate.effective_share", "", 1e-4, 1.0,
                          "Independent measurements per sample at most. Sensor noise comes in "
                          "waves, and real objects are quadrics only nearly: more samples than "
                          "this argue for no richer type."});
    v(o.effective_size,
      {"aggregate.effective_size", "", 10.0, 1e9, "Independent measurements in all at most."});
    v(o.claim, {"aggregate.claim", "", 0.1, 100.0,
                "Factor on the distance within which an accepted quadric claims further samples."});
  }
};

}  // namespace quadrille
