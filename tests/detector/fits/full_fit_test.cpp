#include "fits/full_fit.hpp"

#include <Eigen/SVD>

#include "detector/fits/examples.hpp"
#include "fits/linear_system.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using quadrille::test::curved_forms;
using quadrille::test::difference;
using quadrille::test::sample;

TEST_CASE("the secular equation gives the singular vector of the printed matrix",
          "[fits][paper:eq4]") {
  RandomStream random(61, 0);
  for (const double weight : {1.0, 0.3}) {
    for (const CanonicalForm& form : curved_forms()) {
      CAPTURE(to_string(form.type), weight);
      const auto points =
          test::with_noise(sample(form, 12, random, true).points, 0.02, 0.05, random);
      const auto fit = solve_full_system(points, {weight});
      REQUIRE(fit);
      const auto normalised = normalise(points, 4, Spread::kSpace);
      const Eigen::JacobiSVD<Eigen::MatrixXd> svd(full_system(normalised->data, weight),
                                                  Eigen::ComputeFullV);
      const Vector10d q = svd.matrixV().col(svd.cols() - 1).head<10>();
      CHECK(difference(normalised->undo(Quadric(q))->matrix(), fit->Q.matrix()) < 1e-6);
    }
  }
}

TEST_CASE("the scales of exact data are the lengths of the gradients", "[fits][paper:eq4]") {
  RandomStream random(62, 0);
  const auto s = sample(curved_forms()[1], 20, random, true);
  const auto fit = solve_full_system(s.points);
  REQUIRE(fit);
  for (Eigen::Index i = 0; i < s.points.size(); ++i) {
    CHECK(fit->alpha[i] == Approx(s.Q.gradient(s.points.points.col(i)).norm()).epsilon(1e-5));
  }
}
