#include "variants/measured_quantisation.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("places rise from 0 to 1 with lambda, and lead back to it", "[quantisation]") {
  for (const Quantisation& quantisation : {kArctangent, kMeasured}) {
    float last = 0.0f;
    for (const double e : {-3e3, -100., -8., -1., -0.3, -0.02, 0.0, 0.05, 0.4, 2., 30., 1e3}) {
      const float lambda = static_cast<float>(e), place = quantisation.place_of(lambda);
      CAPTURE(lambda);
      CHECK(place > last);
      CHECK(place < 1.0f);
      CHECK(quantisation.lambda_at(place) == Approx(lambda).epsilon(2e-3).margin(1e-5));
      last = place;
    }
  }
}

TEST_CASE("the arctangent is half way at zero and three quarters at one", "[quantisation]") {
  CHECK(kArctangent.place_of(0.0f) == 0.5f);
  CHECK(kArctangent.place_of(1.0f) == Approx(0.75f));
}
