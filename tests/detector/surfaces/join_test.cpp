#include "surfaces/join.hpp"

#include "detector/pipe.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/surface_fit.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::vector<int> rows(int from, int to) {
  std::vector<int> region;
  for (int i = from * kPipeColumns; i < to * kPipeColumns; ++i) region.push_back(i);
  return region;
}

}  // namespace

TEST_CASE("two pieces of a cylinder join, a piece and a plane do not", "[join]") {
  const SurfaceSamples samples = pipe();
  const auto lower = fit_surface(samples, rows(0, 25), {});
  const auto upper = fit_surface(samples, rows(35, kPipeRows), {});
  REQUIRE(lower);
  REQUIRE(upper);
  const auto whole = join(*lower, *upper, samples, {});
  REQUIRE(whole);
  CHECK(whole->region.size() == lower->region.size() + upper->region.size());
  CHECK(whole->fit.family == Family::kCylinder);
  Surface flat = *upper;
  flat.fit.family = Family::kPlane;
  CHECK_FALSE(join(*lower, flat, samples, {}));
}

TEST_CASE("what lies far off cannot meet", "[join]") {
  const Normalisation here{Eigen::Vector3d::Zero(), 0.1}, there{Eigen::Vector3d(1, 0, 0), 0.1};
  CHECK(may_meet(here, here));
  CHECK_FALSE(may_meet(here, there));
}
