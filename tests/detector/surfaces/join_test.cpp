#include "surfaces/join.hpp"

#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/surface_fit.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kRadius = 0.04;
constexpr int kColumns = 25, kRows = 60;

SurfaceSamples cylinder() { return cylinder_grid(kColumns, kRows, kRadius, 0.004, 0.0005, 1); }

std::vector<int> rows(int from, int to) {
  std::vector<int> region;
  for (int i = from * kColumns; i < to * kColumns; ++i) region.push_back(i);
  return region;
}

}  // namespace

TEST_CASE("two pieces of a cylinder join, a piece and a plane do not", "[join]") {
  const SurfaceSamples samples = cylinder();
  const auto lower = fit_surface(samples, rows(0, 25), {});
  const auto upper = fit_surface(samples, rows(35, kRows), {});
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
