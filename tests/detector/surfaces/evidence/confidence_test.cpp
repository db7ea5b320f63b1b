#include "surfaces/evidence/confidence.hpp"

#include <cmath>
#include <set>

#include "detector/pipe.hpp"
#include "fit/family_spec.hpp"
#include "samples/sample_buckets.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/evidence/confidence_weights.hpp"
#include "surfaces/evidence/intruders.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

using Terms = std::array<double, kConfidenceTerms.size()>;

std::size_t index_of(std::string_view name) {
  for (std::size_t k = 0; k < kConfidenceTerms.size(); ++k) {
    if (kConfidenceTerms[k].name == name) return k;
  }
  FAIL("no term " << name);
  return 0;
}

/// What samples show of a cylinder along z.
Terms terms_of_cylinder(const SurfaceSamples& samples, const std::vector<int>& region,
                        double radius) {
  const Quadric Q(diagonal(1, 1, 0, -radius * radius));
  Evidence e = collect_evidence(samples, region, Q);
  add_intruders(samples, SampleBuckets(samples), region, Q, &e);
  return confidence_terms(e, family_spec(Family::kCylinder).dof, 0.0);
}

Terms terms_of_cylinder() {
  const SurfaceSamples samples = pipe();
  return terms_of_cylinder(samples, all_of(samples), kPipeRadius);
}

double log_odds(double p) { return std::log(p / (1.0 - p)); }

}  // namespace

TEST_CASE("the terms are named, each once, and in the order of their values", "[confidence]") {
  std::set<std::string_view> names;
  for (const ConfidenceTerm& term : kConfidenceTerms) {
    CHECK(names.insert(term.name).second);
    CHECK_FALSE(term.unit.empty());
    CHECK_FALSE(term.meaning.empty());
  }
  Evidence e;
  e.log_count = 5.5, e.spread = 2.0, e.smooth_border = 3.0, e.open_border = 4.0;
  e.depth_edge = 5.0, e.thickness = 6.0, e.size = 0.1, e.cell = 0.01, e.two_planes = 0.4;
  e.one_plane = 0.7, e.interior = 0.6, e.sigma = 0.001, e.common_noise = 0.3, e.residual = 3.0;
  e.roughness = 0.5, e.correlation = 0.2, e.convexity = -1.0;
  e.in_front = 0.95, e.behind = 1.95, e.remainder = 2.95;
  e.uprightness = 0.9, e.see_through = 0.25;
  const Terms terms = confidence_terms(e, 7, -2.0);
  const auto value = [&](std::string_view name) { return terms[index_of(name)]; };
  CHECK(value("log_count") == 5.5);
  CHECK(value("spread") == 2.0);
  CHECK(value("smooth_border") == 3.0);
  CHECK(value("open_border") == 4.0);
  CHECK(value("depth_edge") == 5.0);
  CHECK(value("thickness") == 6.0);
  CHECK(value("log_size") == Approx(std::log(0.1)));
  CHECK(value("log_cell") == Approx(std::log(0.1)));
  CHECK(value("two_planes") == 0.4);
  CHECK(value("one_plane") == 0.7);
  CHECK(value("interior") == 0.6);
  CHECK(value("log_sigma") == Approx(std::log(0.001)));
  CHECK(value("common_noise") == 0.3);
  CHECK(value("log_residual") == Approx(std::log(3.0)));
  CHECK(value("log_roughness") == Approx(std::log(0.5)));
  CHECK(value("correlation") == 0.2);
  CHECK(value("convexity") == -1.0);
  CHECK(value("log_in_front") == Approx(0.0).margin(1e-12));
  CHECK(value("log_behind") == Approx(std::log(2.0)));
  CHECK(value("log_remainder") == Approx(std::log(3.0)));
  CHECK(value("uprightness") == 0.9);
  CHECK(value("see_through") == 0.25);
  CHECK(value("dof") == 7.0);
  CHECK(value("log_prior") == -2.0);
}

TEST_CASE("the log odds are the form over the scaled terms", "[confidence]") {
  const Terms terms = terms_of_cylinder();
  for (const SurfaceKind kind : {SurfaceKind::kCurved, SurfaceKind::kFlat}) {
    const ConfidenceModel& model = kind == SurfaceKind::kCurved ? kCurvedModel : kFlatModel;
    constexpr int n = ConfidenceModel::kSize + 1;
    Eigen::Matrix<double, n, n> form = Eigen::Matrix<double, n, n>::Zero();
    std::size_t next = 0;
    for (int i = 0; i < n; ++i) {
      for (int j = i; j < n; ++j) form(i, j) = model.form[next++];
    }
    Eigen::Matrix<double, n, 1> z = Eigen::Matrix<double, n, 1>::Ones();
    for (int k = 1; k < n; ++k) {
      const TermScale& s = model.scales[static_cast<std::size_t>(k) - 1];
      const double held = std::min(s.max, std::max(s.min, terms[static_cast<std::size_t>(k) - 1]));
      z[k] = (held - s.mean) / s.deviation;
    }
    CHECK(log_odds(confidence(terms, kind)) == Approx(z.dot(form * z)).epsilon(1e-6));
  }
}

TEST_CASE("the scales are those of a training: ordered, and none is empty", "[confidence]") {
  for (const ConfidenceModel* model : {&kCurvedModel, &kFlatModel}) {
    for (const TermScale& scale : model->scales) {
      CHECK(scale.min <= scale.mean);
      CHECK(scale.mean <= scale.max);
      CHECK(scale.deviation > 0.0);
    }
  }
}

TEST_CASE("beyond what the training showed, terms say no more", "[confidence]") {
  Terms terms = terms_of_cylinder();
  const std::size_t residual = index_of("log_residual");
  terms[residual] = kCurvedModel.scales[residual].max + 1.0;
  const double beyond = confidence(terms, SurfaceKind::kCurved);
  terms[residual] += 10.0;
  CHECK(confidence(terms, SurfaceKind::kCurved) == beyond);
}

TEST_CASE("a cylinder is believed, a wrong one and a scrap of one are not", "[confidence]") {
  const SurfaceSamples samples = pipe();
  const auto belief = [&](double radius, int from_row, int to_row) {
    std::vector<int> region;
    for (int i = from_row * kPipeColumns; i < to_row * kPipeColumns; ++i) region.push_back(i);
    return confidence(terms_of_cylinder(samples, region, radius), SurfaceKind::kCurved);
  };
  const double whole = belief(kPipeRadius, 0, kPipeRows);
  CHECK(whole > 0.9);
  CHECK(whole < 1.0);
  CHECK(belief(1.3 * kPipeRadius, 0, kPipeRows) < 0.5 * whole);
  // Cut out of the middle: the surface goes on at both ends. Its odds are a hundred times less.
  const double scrap = belief(kPipeRadius, kPipeRows / 2, kPipeRows / 2 + 2);
  CHECK(log_odds(scrap) < log_odds(whole) - std::log(100.0));
}
