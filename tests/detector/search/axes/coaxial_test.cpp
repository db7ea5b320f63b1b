#include "search/axes/coaxial.hpp"

#include <algorithm>

#include "detector/search/axes/bottle.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr int kMinSamples = 30;

std::vector<Candidate> candidates_of(const SurfaceSamples& samples, const Eigen::Isometry3d& X_CB,
                                     const Mask& free = {}) {
  return coaxial_candidates(samples, free, {{X_CB.translation(), X_CB.linear().col(2)}}, {},
                            kMinSamples);
}

/// Largest distance of a candidate's samples from its quadric [m].
double largest_residual(const SurfaceSamples& samples, const Candidate& candidate) {
  double largest = 0;
  for (const int i : candidate.region) {
    largest = std::max(largest, std::abs(candidate.Q.distance(samples.raw[i].cast<double>())));
  }
  return largest;
}

bool has(const std::vector<Candidate>& list, QuadricType type, double size) {
  return std::any_of(list.begin(), list.end(), [&](const Candidate& c) {
    const CanonicalForm form = canonical_form(c.Q, 1e-5);
    return form.type == type && std::abs(form.dimensions[0].second - size) < 1e-3;
  });
}

}  // namespace

TEST_CASE("one oriented point about a bottle's axis gives its wall, shoulder and neck",
          "[search][axes]") {
  const Eigen::Isometry3d X_CB = some_pose();
  const SurfaceSamples samples = bottle(X_CB, 0.0, 0.0);
  const std::vector<Candidate> found = candidates_of(samples, X_CB);
  REQUIRE(found.size() >= 3);
  // The wall has most of the samples.
  CHECK(found[0].family == Family::kCylinder);
  CHECK(has({found[0]}, QuadricType::kCylinder, kWall));
  CHECK(has(found, QuadricType::kCylinder, kNeck));
  // The shoulder falls by 25 mm over 30.
  CHECK(std::any_of(found.begin(), found.end(), [](const Candidate& c) {
    const CanonicalForm form = canonical_form(c.Q, 1e-5);
    return c.family == Family::kCone &&
           std::abs(std::tan(form.dimensions[0].second) - 25.0 / 30.0) < 0.02;
  }));
  for (std::size_t k = 0; k < 3; ++k) CHECK(largest_residual(samples, found[k]) < 2e-3);
  for (std::size_t k = 1; k < found.size(); ++k) {
    CHECK(found[k].region.size() <= found[k - 1].region.size() * 1.2);
  }
}

TEST_CASE("a ball on the axis is a sphere", "[search][axes]") {
  const Eigen::Isometry3d X_CB = some_pose();
  SurfaceSamples samples;
  constexpr float kRadius = 0.035f;
  for (float slope = -1.2f; slope < 1.2f; slope += 0.09f) {
    for (float turn = -1.5f; turn < 1.5f; turn += 0.09f / std::cos(slope)) {
      const Eigen::Vector3f n(std::cos(slope) * std::cos(turn), std::cos(slope) * std::sin(turn),
                              std::sin(slope));
      add_sample(&samples, X_CB.cast<float>() * Eigen::Vector3f(kRadius * n),
                 X_CB.linear().cast<float>() * n);
    }
  }
  const std::vector<Candidate> found = candidates_of(samples, X_CB);
  REQUIRE_FALSE(found.empty());
  CHECK(found[0].family == Family::kSphere);
  CHECK(has({found[0]}, QuadricType::kSphere, kRadius));
  CHECK(found[0].region.size() > 0.9 * samples.size());
}

TEST_CASE("the wall survives noise and as many outliers; nothing is made of outliers alone",
          "[search][axes]") {
  const Eigen::Isometry3d X_CB = some_pose();
  SurfaceSamples samples = bottle(X_CB, 0.0005, 0.1);
  const int count = samples.size();
  add_outliers(&samples, X_CB, 2000);
  const std::vector<Candidate> found = candidates_of(samples, X_CB);
  REQUIRE_FALSE(found.empty());
  // The true wall, between its ends, lies within a millimetre of what was found.
  for (const double h : {0.01, 0.05, 0.09}) {
    const Eigen::Vector3d p = X_CB * Eigen::Vector3d(kWall, 0.0, h);
    CHECK(std::abs(found[0].Q.distance(p)) < 1e-3);
  }
  const auto of_bottle = std::count_if(found[0].region.begin(), found[0].region.end(),
                                       [&](int i) { return i < count; });
  CHECK(of_bottle > 0.9 * static_cast<double>(found[0].region.size()));

  SurfaceSamples outliers;
  add_outliers(&outliers, X_CB, 2000);
  CHECK(candidates_of(outliers, X_CB).empty());
}

TEST_CASE("samples that are not free and flat lids give no candidate, and a wrong axis small ones",
          "[search][axes]") {
  const Eigen::Isometry3d X_CB = some_pose();
  const SurfaceSamples samples = bottle(X_CB, 0.0, 0.0);
  CHECK(candidates_of(samples, X_CB, Mask(static_cast<std::size_t>(samples.size()), 0)).empty());
  CHECK(candidates_of({}, X_CB).empty());
  Eigen::Isometry3d beside = X_CB;
  beside.translation() += 0.03 * X_CB.linear().col(1);
  for (const Candidate& c : candidates_of(samples, beside)) {
    CHECK(static_cast<int>(c.region.size()) < samples.size() / 3);
  }
  SurfaceSamples lid;
  for (int i = 0; i < 400; ++i) {
    add_sample(&lid,
               X_CB.cast<float>() *
                   Eigen::Vector3f(0.003f * (i % 20) - 0.03f, 0.003f * (i / 20) - 0.03f, 0.1f),
               X_CB.linear().col(2).cast<float>());
  }
  CHECK(candidates_of(lid, X_CB).empty());
}
