#include "boxes/edge_radius.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/quantile.hpp"

namespace quadrille {
namespace {

// Edges have at most this radius [m], and at most this share of the shortest seen side; a larger
// one is cut to it.
constexpr double kMaxRadius = 0.015;
constexpr double kMaxShare = 0.2;
// Ratio of the depths of points in the middle third of a quarter circle, 30° to 60° along it:
// (1 − cos 30°) / (1 − sin 30°).
constexpr double kMinRatio = 0.27;
// Noise rounds a sharp edge. Points that lie beneath both faces by chance, at a depth a below one
// and between kMinRatio a and a / kMinRatio below the other, give this many standard deviations of
// their noise as radius.
constexpr double kNoiseRadius = 6.0;
// Least angle by which the normal of an edge has turned where it is last seen, if its radius
// follows from how far it lies below the face there.
constexpr double kMinTurn = M_PI / 6.0;
// Least number of points that tell a radius, and their least share of those that a rounded edge
// would show.
constexpr std::size_t kMinOnEdges = 16;
constexpr double kMinShown = 0.3;

/// Measurements of the edges of a box.
struct Edges {
  /// The radius that each point beneath two faces gives [m].
  std::vector<double> radii;
  /// Number of points that edges of 1 m radius would show [1/m].
  double expected = 0.0;
  /// Noise along the normals of the faces [m].
  double sigma = 0.0;
};

void add_edge(const BoxDraft& draft, int i, int k, Edges* edges) {
  const Face& first = *draft.faces[i];
  const Face& second = *draft.faces[k];
  const int along = 3 - i - k;
  const double low = draft.reach_A.min()[along], high = draft.reach_A.max()[along];
  const double margin = std::min(kMaxRadius, 0.25 * (high - low));
  for (const Eigen::Vector3d& p_C : draft.around_C) {
    const double a = -first.height(p_C), b = -second.height(p_C);
    if (!(a > 0.0 && b > 0.0 && std::min(a, b) >= kMinRatio * std::max(a, b))) continue;
    const double place = draft.R_CA.col(along).dot(p_C);
    if (place < low + margin || place > high - margin) continue;
    const double radius = a + b + std::sqrt(2.0 * a * b);
    if (radius <= kMaxRadius) edges->radii.push_back(radius);
  }
  const double pitch = std::max(first.pitch, second.pitch);
  edges->expected += M_PI / 6.0 * (high - low - 2.0 * margin) / (pitch * pitch);
  // A face that bends seems noisy, so the flatter one tells the noise along lines of sight.
  const double along_sight = std::min(first.sigma / first.cosine, second.sigma / second.cosine);
  edges->sigma = std::max(edges->sigma, along_sight * std::max(first.cosine, second.cosine));
}

}  // namespace

double edge_radius(const BoxDraft& draft) {
  Edges edges;
  for (int i = 0; i < static_cast<int>(draft.faces.size()); ++i) {
    for (int k = 0; k < i; ++k) add_edge(draft, i, k, &edges);
  }
  const auto shown = static_cast<double>(edges.radii.size());
  if (edges.radii.size() < kMinOnEdges) return 0.0;
  const double radius = median(edges.radii), of_noise = kNoiseRadius * edges.sigma;
  if (shown < kMinShown * edges.expected * radius || radius < of_noise) return 0.0;
  return std::min(std::sqrt(radius * radius - of_noise * of_noise),
                  kMaxShare * draft.reach_A.sizes().minCoeff());
}

double reach_beyond(const Face& face, const TurningEdge& turning, double radius,
                    const Eigen::Vector3d& out_C, const DirectionIndex& sight) {
  if (!sight.single()) return 0.0;
  // The line of sight touches the edge where the normal has turned by this angle.
  const Eigen::Vector3d ahead_C = (face.middle_C - sight.eye()).normalized();
  const double turn =
      std::atan2(std::abs(face.n_C.dot(ahead_C)), std::max(0.0, out_C.dot(ahead_C)));
  if (radius == 0.0) {
    if (turn > kMinTurn) radius = std::min(kMaxRadius, turning.drop / (1.0 - std::cos(turn)));
    return turning.beyond + radius * (1.0 - std::sin(turn));
  }
  // The part of the edge that lies within the face's tolerance counts as the face's own.
  const double depth = std::min(face.tolerance(), radius);
  const double shown = std::min(std::sqrt(depth * (2.0 * radius - depth)), radius * std::sin(turn));
  return std::max(turning.beyond + radius * (1.0 - std::sin(turn)), radius - shown);
}

}  // namespace quadrille
