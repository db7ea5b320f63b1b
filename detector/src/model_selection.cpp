#include "quadrille/detector/model_selection.hpp"

#include <algorithm>
#include <cmath>

#include "quadrille/detector/initial_fits.hpp"

namespace quadrille {
namespace {

/// Starts for one family; `known` are the fits so far, on which some build.
std::vector<PosedQuadric> starts(const FitPoints& points, Family family,
                                 const std::vector<FamilyFit>& known) {
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
      add(initial_plane(points));
      break;
    case Family::kSphere:
      add(initial_sphere(points));
      break;
    case Family::kCylinder:
      add(initial_cylinder(points));
      break;
    case Family::kCone:
      add(initial_cone(points));
      break;
    case Family::kRevolution:
      add(initial_revolution(points));
      add_known(Family::kCone, same);
      break;
    case Family::kParaboloid:
      add_known(Family::kRevolution, [](const PosedQuadric& q) { return initial_paraboloid(q); });
      break;
    case Family::kEllipticCylinder:
      add_known(Family::kCylinder, [](const PosedQuadric& q) {
        PosedQuadric unit = q;
        unit.D /= -q.D(3, 3);
        return std::optional(unit);
      });
      break;
    case Family::kGeneral:
      add(initial_general(points));
      break;
  }
  return list;
}

}  // namespace

double bic(double rss, int size, int dof, const SelectionOptions& options) {
  const double n = std::max(2.0, options.effective_share * size);
  const double variance = rss / size + options.floor * options.floor + 1e-18;
  return n * std::log(variance) + dof * std::log(n);
}

std::optional<Selection> select_family(const FitPoints& points, std::span<const Family> families,
                                       const SelectionOptions& options) {
  Selection selection;
  const int size = static_cast<int>(points.size());
  bool found = false;
  for (const Family family : families) {
    std::optional<FamilyFit> best;
    for (const PosedQuadric& start : starts(points, family, selection.fits)) {
      const std::optional<FamilyFit> fit = refine(points, family, start, options.iterations);
      if (fit && (!best || fit->rss < best->rss)) best = fit;
    }
    if (!best) continue;
    const double value = bic(best->rss, size, family_spec(family).dof, options);
    if (!found || value < selection.bic) {
      selection.best = *best;
      selection.bic = value;
      found = true;
    }
    selection.fits.push_back(std::move(*best));
  }
  if (!found) return std::nullopt;
  return selection;
}

}  // namespace quadrille
