#include "fit/starts.hpp"

#include "fit/closed_form/initial_cone.hpp"
#include "fit/closed_form/initial_cylinder.hpp"
#include "fit/closed_form/initial_general.hpp"
#include "fit/closed_form/initial_plane.hpp"
#include "fit/closed_form/initial_revolution.hpp"
#include "fit/closed_form/initial_sphere.hpp"
#include "fit/closed_form/special_generals.hpp"
#include "fit/closed_form/special_revolutions.hpp"

namespace quadrille {
namespace {

/// Returns the same surface with its matrix divided by a number.
std::optional<PosedQuadric> divided(PosedQuadric q, double by) {
  q.D /= by;
  return q;
}

}  // namespace

std::vector<PosedQuadric> Starts::of(Family family, const std::vector<FamilyFit>& known) {
  std::vector<PosedQuadric> list;
  const auto add = [&](const std::optional<PosedQuadric>& start) {
    if (start) list.push_back(*start);
  };
  const auto add_known = [&](Family wanted, auto&& change) {
    for (const FamilyFit& fit : known) {
      if (fit.family == wanted) add(change(fit.posed));
    }
  };
  const auto same = [](const PosedQuadric& q) { return std::optional(q); };
  switch (family) {
    case Family::kPlane:
      add(initial_plane(moments_));
      break;
    case Family::kSphere:
      add(initial_sphere(moments_));
      break;
    case Family::kCylinder:
      add(initial_cylinder(moments_));
      if (revolution()) add(tangent_cylinder(*revolution()));
      break;
    case Family::kCone:
      add(initial_cone(moments_));
      if (revolution()) add(tangent_cone(*revolution()));
      break;
    case Family::kRevolution:
      add(revolution());
      add_known(Family::kCone, same);
      break;
    case Family::kParaboloid:
      add_known(Family::kRevolution, initial_paraboloid);
      break;
    case Family::kEllipticCylinder:
      add_known(Family::kGeneral, nearest_cylindrical);
      add_known(Family::kCylinder, [](const auto& q) { return divided(q, -q.D(3, 3)); });
      break;
    case Family::kParabolic:
      add_known(Family::kGeneral, nearest_parabolic);
      add_known(Family::kParaboloid, [](const auto& q) { return divided(q, q.D(2, 3)); });
      break;
    case Family::kGeneral:
      add(initial_general(moments_));
      break;
  }
  return list;
}

const std::optional<PosedQuadric>& Starts::revolution() {
  if (!revolution_) revolution_ = initial_revolution(moments_);
  return *revolution_;
}

}  // namespace quadrille
