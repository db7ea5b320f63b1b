#include "surfaces/sensor_correlation.hpp"

#include <numeric>
#include <vector>

#include "support/catch.hpp"

namespace quadrille {
namespace {

Surface of_samples(int samples, double correlation) {
  Surface surface;
  surface.region.resize(static_cast<std::size_t>(samples));
  std::iota(surface.region.begin(), surface.region.end(), 0);
  surface.evidence.correlation = correlation;
  return surface;
}

TEST_CASE("a surface shares at least as much noise as the sensor makes the others share",
          "[surfaces]") {
  std::vector<Surface> surfaces = {of_samples(3000, 0.5), of_samples(1000, 0.1),
                                   of_samples(1000, 0.9)};
  share_correlation(&surfaces);
  CHECK(surfaces[0].evidence.correlation == Approx(0.5));
  CHECK(surfaces[1].evidence.correlation == Approx(0.5));
  CHECK(surfaces[2].evidence.correlation == Approx(0.9));
}

TEST_CASE("surfaces with white noise keep the correlations that chance gives them", "[surfaces]") {
  std::vector<Surface> surfaces = {of_samples(3000, 0.04), of_samples(200, -0.1),
                                   of_samples(100, 0.3)};
  share_correlation(&surfaces);
  CHECK(surfaces[0].evidence.correlation == 0.04);
  CHECK(surfaces[1].evidence.correlation == -0.1);
  CHECK(surfaces[2].evidence.correlation == 0.3);
  std::vector<Surface> none;
  share_correlation(&none);
  CHECK(none.empty());
}

}  // namespace
}  // namespace quadrille
