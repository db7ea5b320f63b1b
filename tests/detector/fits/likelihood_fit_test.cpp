#include "fits/likelihood_fit.hpp"

#include "detector/fits/examples.hpp"
#include "fits/contenders.hpp"
#include "fits/projection.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using quadrille::test::curved_forms;
using quadrille::test::sample;

namespace {

struct Error {
  double distance = 0.0, angle = 0.0;
};

/// The paper's point and angle error: from each true point to the fit, and between true normal and
/// gradient.
Error error(const Quadric& Q, const OrientedPointsd& truth) {
  Error sum;
  const double count = static_cast<double>(truth.size());
  for (Eigen::Index i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d x = truth.points.col(i), n = truth.normals.col(i);
    const auto foot = project(Q, x);
    sum.distance += (foot ? std::min(1.0, (*foot - x).norm()) : 1.0) / count;
    sum.angle += (1.0 - n.dot(Q.gradient(x).normalized())) / count;
  }
  return sum;
}

}  // namespace

TEST_CASE("the noise of points and normals is found with the quadric", "[fits][likelihood]") {
  RandomStream random(81, 0);
  for (const int which : {0, 1, 2, 8}) {
    const CanonicalForm form = curved_forms()[which];
    CAPTURE(to_string(form.type));
    const auto s = sample(form, 600, random, true);
    const auto fit = solve_likelihood(test::with_noise(s.points, 0.01, 0.05, random));
    REQUIRE(fit);
    CHECK(fit->point_noise == Approx(0.01).epsilon(0.1));
    CHECK(fit->normal_noise == Approx(0.05).epsilon(0.1));
  }
}

TEST_CASE("the likelihood fit beats every other fit in points and angles at each level of noise",
          "[fits][likelihood][paper:fig5]") {
  const std::vector<int> which = {0, 1, 2, 3, 6, 7, 8};
  for (const double noise : {0.02, 0.06, 0.1}) {
    std::vector<Error> sums(contenders(QuadricType::kSphere).size());
    for (const int k : which) {
      const CanonicalForm form = curved_forms()[k];
      const auto all = contenders(form.type);
      for (int trial = 0; trial < 3; ++trial) {
        RandomStream random(82 + k, trial);
        const auto truth = sample(form, 200, random, true).points;
        OrientedPointsd data = truth;
        data.points = test::with_noise(truth, noise, 0.0, random).points;
        for (std::size_t m = 0; m < all.size(); ++m) {
          const auto Q = all[m].fit(data);
          const Error e = Q ? error(*Q, truth) : Error{1.0, 1.0};
          sums[m].distance += e.distance, sums[m].angle += e.angle;
        }
      }
    }
    const auto all = contenders(QuadricType::kSphere);
    const Error best = sums[find_contender(all, "likelihood") - all.data()];
    for (std::size_t m = 0; m < all.size(); ++m) {
      if (all[m].ours) continue;
      CAPTURE(noise, all[m].name);
      CHECK(best.distance < sums[m].distance);
      CHECK(best.angle < sums[m].angle);
    }
  }
}
