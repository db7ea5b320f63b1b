#pragma once

#include <optional>

#include "quadrille/detector/detector.hpp"
#include "search/hypotheses.hpp"
#include "variants/agglomerate.hpp"
#include "variants/triplet_set.hpp"

namespace quadrille {

/// Ways to draw hypotheses from a neighbourhood.
enum class VariantBasis {
  kThreePoints,  ///< three oriented points and a vote along their null space (paper, section 4)
  kFourPoints,   ///< three oriented points and a fourth point, which fixes λ (paper, theorem 3)
  kNinePoints,   ///< nine points without normals
  kTwoPoints,    ///< two oriented points and a vote in three dimensions (paper, figure 2b)
  kCylinder,     ///< two oriented points, which determine a circular cylinder
  kCone,         ///< three oriented points, which determine a circular cone
};

/// Lengths given to the gradients at three oriented points, since normals tell only their
/// directions.
enum class GradientLengths {
  kCommon,  ///< one length for all (paper, eq. 5); exact on spheres and circular cylinders
  kSolved,  ///< the lengths with which the points lie on one quadric (paper, eq. 4)
};

/// The paper's clustering of hypotheses as printed, applied to raw hypotheses before any is grown.
struct ClusterOptions {
  /// τ: largest ‖q₁ − q₂‖₁ of unit coefficients in coordinates of the neighbourhood.
  double max_difference = 0.4;
  /// Largest d_close of two members of a cluster.
  double max_close = 0.4;
};

/// A variant of the detector's search. The defaults are the detector's own way.
struct Variant {
  VariantBasis basis = VariantBasis::kThreePoints;
  /// Lengths of the gradients at three or four points. Solved ones find more kinds of quadrics with
  /// a third of the bases, but in whole scenes fewer small surfaces and faces beside others.
  GradientLengths lengths = GradientLengths::kCommon;
  /// The way in which votes are put into bins.
  Quantisation quantisation = kArctangent;
  /// Above 0, no more bases are drawn than one of points on the best surface so far takes, with
  /// this confidence.
  double confidence = 0.0;
  /// If true, a basis of three points is voted on only once (paper, section 5).
  bool hash_triplets = false;
  /// If set, the hypotheses of a neighbourhood are agglomerated, and the cluster is taken that has
  /// the most support in total.
  std::optional<ClusterOptions> clusters = std::nullopt;
  /// If set, candidates are clustered before the aggregation chooses among them.
  std::optional<AgglomerateOptions> agglomerate = std::nullopt;
};

/// Returns the way in which a variant proposes the quadric of a neighbourhood.
/// @param bases  number of bases to draw, at most
/// @param seen   bases of three points that are refused, and receives those that are voted on; must
///   outlive the result; null to vote on repeated bases too
Propose propose_variant(const Variant& variant, int bases, TripletSet* seen = nullptr);

/// detect() with a variant of the search, which replaces `search.basis`.
/// @throws std::invalid_argument if an option is out of range
DetectionResult detect_variant(const CloudView& cloud, const DetectorOptions& options,
                               const Variant& variant);

}  // namespace quadrille
