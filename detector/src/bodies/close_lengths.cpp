#include "bodies/close_lengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "bodies/axial_part.hpp"
#include "bodies/profile.hpp"
#include "surfaces/uncertainty.hpp"

namespace quadrille {
namespace {

/// An end of a cylinder along z of its canonical frame, and its standard deviation [m].
struct End {
  double z, std;
};

/// The cylinder, and another part about its axis.
struct Neighbours {
  int cylinder, other;
};

/// Heights, in the canonical frame of the other surface and in its local coordinates, at which its
/// radius is that of the cylinder.
std::vector<double> meeting_heights(const Surface& other, double radius) {
  const Eigen::Matrix4d& D = other.fit.posed.D;
  const double r = radius / other.local.scale;
  const double a = D(2, 2), b = 2.0 * D(2, 3), c = D(3, 3) + D(0, 0) * r * r;
  if (a == 0.0) return b == 0.0 ? std::vector<double>() : std::vector{-c / b};
  const double square = b * b - 4.0 * a * c;
  if (square < 0.0) return {};
  return {(-b - std::sqrt(square)) / (2.0 * a), (-b + std::sqrt(square)) / (2.0 * a)};
}

/// Slope of the radius at a place of a profile.
double slope_at(const Eigen::Matrix4d& D, const Place& place) {
  return -(D(2, 2) * place.height + D(2, 3)) / (D(0, 0) * place.radius);
}

/// Standard deviation of the height at which two profiles meet [m].
double meeting_std(const Neighbours& parts, const Place& at_cylinder, const Place& at_other,
                   const std::vector<LastFit>& fits, const SurfaceSamples& samples,
                   std::span<const CommonAxis> axes) {
  const Surface &a = fits[parts.cylinder].surface, &b = fits[parts.other].surface;
  const double slope = slope_at(b.fit.posed.D, at_other), stretch = std::hypot(1.0, slope);
  // A profile that lies farther out by d along its normal has a radius that is d √(1 + slope²)
  // larger.
  const Eigen::VectorXd g_a = mean_distance(a, {at_cylinder}, own_axis(a)).derivative;
  const Eigen::VectorXd g_b = stretch * mean_distance(b, {at_other}, own_axis(b)).derivative;
  double variance = g_a.dot(parameter_covariance(a) * g_a) + g_b.dot(parameter_covariance(b) * g_b);
  if (const auto between = parameter_covariance(parts.cylinder, parts.other, axes)) {
    variance -= 2.0 * g_a.dot(*between * g_b);
  }
  // The sensor moves both surfaces to the same side.
  const double offset =
      stretch * b.local.scale * offset_std(b, samples) - a.local.scale * offset_std(a, samples);
  return std::hypot(std::sqrt(std::max(0.0, variance)), offset) / std::abs(slope);
}

/// Finds where cylinders end.
class Closing {
 public:
  Closing(const std::vector<Detection>& detections, const std::vector<LastFit>& fits,
          const SurfaceSamples& samples, std::span<const CommonAxis> axes)
      : detections_(detections), fits_(fits), samples_(samples), axes_(axes) {
    for (std::size_t k = 0; k < fits.size(); ++k) {
      parts_.push_back(is_turned(fits[k]) ? axial_part(detections[k]) : std::nullopt);
    }
  }

  /// The length of a cylinder; nullopt if no next piece tells more of it.
  std::optional<Dimension> length_of(int k) const {
    const Detection& d = detections_[k];
    if (d.type != QuadricType::kCylinder || !parts_[k]) return std::nullopt;
    const Dimension& length = d.dimensions[1];
    if (!std::isfinite(length.std)) return std::nullopt;
    // Both ends have the same part in the length and in its deviation.
    const double beyond = 0.5 * (length.value - d.extent_Q.sizes().z());
    const double std = length.std / std::numbers::sqrt2;
    std::array<End, 2> ends = {
        {{d.extent_Q.min().z() - beyond, std}, {d.extent_Q.max().z() + beyond, std}}};
    bool closed = false;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      closed |= close(k, static_cast<int>(i), &ends);
    }
    if (!closed || !(ends[1].z > ends[0].z)) return std::nullopt;
    const double both = std::hypot(ends[0].std, ends[1].std);
    return Dimension{length.name, ends[1].z - ends[0].z, both};
  }

 private:
  /// Moves an end of a cylinder to where another part meets it, if that is the next piece and tells
  /// more of the end.
  /// @return true if an end was moved
  bool close(int k, int i, std::array<End, 2>* ends) const {
    if (i == k || !parts_[i] || parts_[i]->axis_C.isZero()) return false;
    const Detection &d = detections_[k], &next = detections_[i];
    if (shows_inside(d) != shows_inside(next) || !share_axis(*parts_[k], *parts_[i])) {
      return false;
    }
    const Surface& other = fits_[i].surface;
    const Eigen::Isometry3d X_QC = d.X_CQ.inverse();
    const double radius = d.dimensions[0].value, reach = kMaxGapShare * radius;
    const double middle = (X_QC * parts_[i]->middle_C).z();
    const double half = parts_[i]->half_length;
    const bool is_upper = middle > d.extent_Q.center().z();
    End& end = (*ends)[is_upper ? 1 : 0];
    // The next piece begins near the end, where this one's samples end or before.
    const double begin = is_upper ? middle - half : middle + half;
    const double last = is_upper ? d.extent_Q.max().z() : d.extent_Q.min().z();
    if (std::abs(begin - last) > reach) return false;
    bool moves = false;
    for (const double z : meeting_heights(other, radius)) {
      const double unit = other.local.scale;
      const Eigen::Vector3d p_C =
          other.local.centre + unit * (other.fit.posed.X * Eigen::Vector3d(0.0, 0.0, z));
      const double at = (X_QC * p_C).z();
      // A cone meets the cylinder again beyond its apex.
      if (!(std::abs(at - last) < reach) || is_upper != (at < middle)) continue;
      const Surface& own = fits_[k].surface;
      const Place at_other{radius / unit, z};
      const Place at_own{radius / own.local.scale, height_in(own, p_C, own_axis(own))};
      const double std = meeting_std({k, i}, at_own, at_other, fits_, samples_, axes_);
      if (!(std < end.std)) continue;
      end = {at, std};
      moves = true;
    }
    return moves;
  }

  const std::vector<Detection>& detections_;
  const std::vector<LastFit>& fits_;
  const SurfaceSamples& samples_;
  std::span<const CommonAxis> axes_;
  /// The surfaces of revolution as parts of bodies.
  std::vector<std::optional<AxialPart>> parts_;
};

}  // namespace

void close_lengths(const std::vector<LastFit>& fits, const SurfaceSamples& samples,
                   std::span<const CommonAxis> axes, std::vector<Detection>* detections) {
  std::vector<std::optional<Dimension>> lengths;
  const Closing closing(*detections, fits, samples, axes);
  for (std::size_t k = 0; k < fits.size(); ++k) {
    lengths.push_back(closing.length_of(static_cast<int>(k)));
  }
  for (std::size_t k = 0; k < fits.size(); ++k) {
    if (lengths[k]) (*detections)[k].dimensions[1] = *lengths[k];
  }
}

}  // namespace quadrille
