#include "quadrille/detector/aggregate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {
namespace {

constexpr std::array kAllFamilies = {
    Family::kPlane,      Family::kSphere,     Family::kCylinder,         Family::kCone,
    Family::kRevolution, Family::kParaboloid, Family::kEllipticCylinder, Family::kGeneral};

/// Area explained, weighted by how well: a truncated quadratic in the distance.
double support(const SurfaceSamples& samples, const Candidate& c, const InlierTest& test,
               const std::vector<char>& claimed) {
  double sum = 0;
  for (const int i : c.region) {
    if (claimed[i]) continue;
    const double d = c.Q.distance(samples.raw[i].cast<double>()) / (test.sigmas * samples.sigma[i]);
    sum += std::max(0.0, 1.0 - d * d) * samples.cell[i] * samples.cell[i];
  }
  return sum;
}

class Aggregation {
 public:
  Aggregation(const SurfaceSamples& samples, const AggregateOptions& options)
      : samples_(samples), options_(options), claimed_(samples.p.size(), 0) {
    selection_.effective_share = options.effective_share;
    selection_.iterations = 10;
  }

  std::vector<Surface> run(std::vector<Candidate> candidates) {
    std::vector<double> value;
    for (const Candidate& c : candidates) {
      value.push_back(support(samples_, c, options_.inlier, claimed_));
    }
    std::vector<Surface> surfaces;
    while (true) {
      const auto best = std::max_element(value.begin(), value.end());
      if (best == value.end() || *best <= 0) break;
      const std::size_t k = static_cast<std::size_t>(best - value.begin());
      *best = 0;
      std::vector<int> open;
      for (const int i : candidates[k].region) {
        if (!claimed_[i]) open.push_back(i);
      }
      if (static_cast<int>(open.size()) < options_.least_samples ||
          static_cast<double>(open.size()) <
              options_.least_open * static_cast<double>(candidates[k].region.size())) {
        continue;
      }
      std::optional<Surface> surface = fitted(open);
      if (!surface) continue;
      extend(&*surface);
      merge(&*surface, &surfaces);
      surface->evidence = collect_evidence(samples_, surface->region, surface->Q);
      const int dof = family_spec(surface->fit.family).dof;
      surface->score = confidence(surface->evidence, dof);
      static const double th = getenv("QTH") ? atof(getenv("QTH")) : 0.4;
      if (surface->fit.family != Family::kPlane && surface->score < th) continue;
      for (const int i : surface->region) claimed_[i] = 1;
      surfaces.push_back(std::move(*surface));
      for (std::size_t c = 0; c < candidates.size(); ++c) {
        if (value[c] > 0) value[c] = support(samples_, candidates[c], options_.inlier, claimed_);
      }
    }
    return surfaces;
  }

 private:
  std::optional<Surface> fitted(std::vector<int> region) const {
    Surface surface;
    surface.local = normalisation_of(samples_, region);
    const FitPoints points = fit_points(samples_, region, surface.local, options_.fit_points);
    std::optional<Selection> selection = select_family(points, kAllFamilies, selection_);
    if (!selection) return std::nullopt;
    surface.Q = surface.local.to_frame(selection->best.posed.matrix()).normalized();
    surface.rms = surface.local.scale *
                  std::sqrt(selection->best.rss / static_cast<double>(points.size()));
    surface.fit = std::move(selection->best);
    surface.region = std::move(region);
    return surface;
  }

  /// Adds all open samples within the quadric's extent that lie on it, and refits if they are
  /// many: the other side of an occluder, the inside of a bowl.
  void extend(Surface* surface) const {
    const std::vector<int> more = further(*surface);
    std::vector<int> all = surface->region;
    all.insert(all.end(), more.begin(), more.end());
    if (more.size() > surface->region.size() / 50) {
      std::optional<Surface> refit = fitted(all);
      if (refit && refit->rms < 1.3 * surface->rms) {
        *surface = std::move(*refit);
        return;
      }
    }
    surface->region = std::move(all);
  }

  double bic_of(const Surface& s) const {
    const double n = static_cast<double>(s.region.size());
    const double r = s.rms;
    return bic(r * r * n, static_cast<int>(n), family_spec(s.fit.family).dof, selection_);
  }

  /// Joins the surface with earlier ones where one quadric explains both.
  void merge(Surface* surface, std::vector<Surface>* others) const {
    for (std::size_t k = 0; k < others->size();) {
      Surface& other = (*others)[k];
      const bool flat = surface->fit.family == Family::kPlane, other_flat = other.fit.family == Family::kPlane;
      const double reach = 2.5 * (surface->local.scale + other.local.scale);
      if (flat != other_flat || (surface->local.centre - other.local.centre).norm() > reach) {
        ++k;
        continue;
      }
      std::vector<int> all = other.region;
      all.insert(all.end(), surface->region.begin(), surface->region.end());
      std::optional<Surface> joint = fitted(all);
      if (joint && joint->rms < 1.25 * std::max(surface->rms, other.rms) &&
          bic_of(*joint) < bic_of(*surface) + bic_of(other)) {
        *surface = std::move(*joint);
        others->erase(others->begin() + static_cast<std::ptrdiff_t>(k));
      } else {
        ++k;
      }
    }
  }

  std::vector<int> further(const Surface& surface) const {
    const Eigen::Isometry3d Y = surface.fit.posed.X.inverse();
    const auto posed = [&](int i) -> Eigen::Vector3d {
      return Y * ((samples_.raw[i].cast<double>() - surface.local.centre) / surface.local.scale);
    };
    Eigen::AlignedBox3d box;
    for (const int i : surface.region) box.extend(posed(i));
    const Eigen::Vector3d margin = 0.15 * box.sizes();
    box.extend(box.min() - margin);
    box.extend(box.max() + margin);
    std::vector<char> inside(samples_.p.size(), 0);
    for (const int i : surface.region) inside[i] = 1;
    InlierTest test = options_.inlier;
    test.sigmas *= static_cast<float>(options_.claim);
    const Eigen::Matrix4f Q = surface.Q.matrix().cast<float>();
    std::vector<int> more;
    for (int i = 0; i < samples_.size(); ++i) {
      if (claimed_[i] || inside[i] || !is_inlier(samples_, i, Q, test)) continue;
      if (box.contains(posed(i))) more.push_back(i);
    }
    return more;
  }

  const SurfaceSamples& samples_;
  const AggregateOptions& options_;
  SelectionOptions selection_;
  std::vector<char> claimed_;
};

}  // namespace

std::vector<Surface> aggregate(const SurfaceSamples& samples, std::vector<Candidate> candidates,
                               const AggregateOptions& options) {
  return Aggregation(samples, options).run(std::move(candidates));
}

}  // namespace quadrille
