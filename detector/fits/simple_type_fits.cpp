#include "fits/simple_type_fits.hpp"

#include "fits/axis.hpp"
#include "fits/type_design.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// The designs hold in the frame of the data, so types are exact up to rounding.
constexpr double kSimpleTypeTolerance = 1e-8;

bool is_spheroid(const Quadric& Q) {
  const QuadricType type = canonical_form(Q, kSimpleTypeTolerance).type;
  return type == QuadricType::kEllipsoid || type == QuadricType::kSphere;
}

std::optional<Quadric> fit_checked(const NormalisedPoints& points, const Design& B, double weight,
                                   QuadricType type) {
  const auto Q = fit_design(points.data, B, weight);
  if (!Q || canonical_form(*Q, kSimpleTypeTolerance).type != type) return std::nullopt;
  return points.undo(*Q);
}

}  // namespace

std::optional<Quadric> fit_plane(const OrientedPointsd& points, const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 3, Spread::kPlane);
  if (!normalised) return std::nullopt;
  return fit_checked(*normalised, plane_design(), options.weight, QuadricType::kPlane);
}

std::optional<Quadric> fit_sphere(const OrientedPointsd& points, const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 2, Spread::kLine);
  if (!normalised) return std::nullopt;
  return fit_checked(*normalised, sphere_design(), options.weight, QuadricType::kSphere);
}

std::optional<Quadric> fit_spheroid(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const auto axis = direction_of_revolution(normalised->data);
  // Every line through a sphere's centre is an axis.
  if (!axis) return fit_sphere(points, options);
  const auto Q = fit_design(normalised->data, spheroid_design(*axis), options.weight);
  if (!Q || !is_spheroid(*Q)) return std::nullopt;
  return normalised->undo(*Q);
}

std::optional<Quadric> fit_cylinder(const OrientedPointsd& points,
                                    const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 2, Spread::kLine);
  if (!normalised) return std::nullopt;
  const auto axis = direction_across_normals(normalised->data);
  if (!axis) return std::nullopt;
  return fit_checked(*normalised, cylinder_design(*axis), options.weight, QuadricType::kCylinder);
}

std::optional<Quadric> fit_cone(const OrientedPointsd& points, const SimpleTypeOptions& options) {
  const auto normalised = normalise(points, 3, Spread::kPlane);
  if (!normalised) return std::nullopt;
  const auto apex = common_point_of_planes(normalised->data);
  if (!apex || !(apex->norm() < 1e3)) return std::nullopt;
  const auto axis = cone_axis(normalised->data, *apex);
  if (!axis) return std::nullopt;
  return fit_checked(*normalised, cone_design(*apex, *axis), options.weight, QuadricType::kCone);
}

}  // namespace quadrille
