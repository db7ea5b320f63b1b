#include "track/surface_look.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace quadrille {
namespace {

// Standard deviation of a dimension in addition to its published one, as a share of its value:
// types and seen parts change between views.
constexpr double kDimensionShare = 0.1;
// Largest cost of one dimension, since a single wild fit does not make another object.
constexpr double kMaxDimensionCost = 4.0;
// Cost of a different type. It replaces the cost of dimensions, which cannot be compared then.
constexpr double kOtherTypeCost = 0.5;
// Standard deviations of the turn of normals [rad], and of the gap as a share of the size.
constexpr double kTurnDeviation = 0.35, kGapDeviation = 0.25;

double squared(double x) { return x * x; }

/// True if a dimension measures only the seen part and not the whole object.
bool depends_on_view(std::string_view dimension) {
  return dimension == "length" || dimension == "width" || dimension == "height";
}

/// Mean squared difference, in standard deviations, of the dimensions that both have.
double compare_dimensions(const std::vector<Dimension>& a, const std::vector<Dimension>& b) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i].name != b[i].name || depends_on_view(a[i].name)) continue;
    const double scale = kDimensionShare * std::max(std::abs(a[i].value), std::abs(b[i].value));
    const double variance = squared(a[i].std) + squared(b[i].std) + squared(scale);
    // Dimensions whose deviations could not be estimated are not compared.
    if (!std::isfinite(variance) || !(variance > 0.0)) continue;
    sum += std::min(kMaxDimensionCost, squared(a[i].value - b[i].value) / variance);
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

/// Squared difference of shapes and extents, in standard deviations.
double compare_shapes(const PatchMatch& match, const SeenPatch& a, const SeenPatch& b) {
  const double size = 0.5 * (a.size + b.size);
  const double noise = std::hypot(a.rms, b.rms, kFitShare * size);
  return squared(match.residual / noise) + squared(match.turn / kTurnDeviation) +
         squared(match.gap / (kGapDeviation * size)) + (1.0 - match.overlap);
}

}  // namespace

SurfaceLook look_of(const Detection& detection, const Eigen::Isometry3d& X_WC) {
  return {detection.type, detection.dimensions, seen_patch(detection, X_WC)};
}

double place_std(const SurfaceLook& look) { return place_std(look.patch); }

SurfaceLook translated(SurfaceLook look, const Eigen::Vector3d& shift_W) {
  look.patch = translated(std::move(look.patch), shift_W);
  return look;
}

LookMatch match_looks(const SurfaceLook& from, const SurfaceLook& to, const Expectation& expected) {
  const double variance =
      squared(place_std(from)) + squared(place_std(to)) + expected.motion_variance;
  // A detection farther away is another surface, although a plane that slides in itself shows no
  // shift. The seen part may have moved by up to its own size.
  const double max_distance = expected.gate * std::sqrt(variance) + from.patch.size + to.patch.size;
  if ((to.patch.centre_W - from.patch.centre_W).norm() > max_distance) return {};
  const PatchMatch match = match_patches(from.patch, to.patch);
  const double place = match.shift_W.squaredNorm() / variance;
  if (!(place < squared(expected.gate))) return {};
  const double named =
      from.type == to.type ? compare_dimensions(from.dimensions, to.dimensions) : kOtherTypeCost;
  return {match.shift_W, place + compare_shapes(match, from.patch, to.patch) + named};
}

}  // namespace quadrille
