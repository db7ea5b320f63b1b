#include "detector/table_scene.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "support/catch.hpp"
#include "support/missing_codes.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Applies the rule point by point in double precision, as an independent truth.
std::size_t count_in_range(const CloudView& cloud) {
  std::size_t count = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    count += (p.cast<double>() - cloud.viewpoint).norm() <= kMaxRange;
  }
  return count;
}

}  // namespace

TEST_CASE("points are counted by their distance from the viewpoint", "[range]") {
  for (int size = 100; size < 140; ++size) {
    PointCloud cloud;
    RandomStream random(31, static_cast<std::uint64_t>(size));
    cloud.viewpoint = Eigen::Vector3d(5000.0, -3000.0, 20.0) * random.uniform();
    for (int i = 0; i < size; ++i) {
      const double u = random.uniform(), angle = 2.0 * M_PI * random.uniform();
      const double r = u < 0.5 ? 4.0 * u : u < 0.7 ? 500.0 + 1000.0 * u : u < 0.9 ? 1e6 : NAN;
      const Eigen::Vector3d ray(r * std::cos(angle), r * std::sin(angle), 0.0);
      cloud.points.push_back((cloud.viewpoint + ray).cast<float>());
    }
    const RangeCheck check = check_range(cloud);
    CHECK(check.near == count_in_range(cloud));
    std::size_t finite = 0;
    for (const Eigen::Vector3f& p : cloud.points) finite += p.allFinite();
    CHECK(check.far == finite - check.near);
  }
}

TEST_CASE("nothing of a cloud in range is copied, wherever its frame has its origin", "[range]") {
  for (const double far : {0.0, 1e4, 5e6}) {
    PointCloud cloud = moved_cloud(table_cloud(), translation(far, -0.5 * far, 10.0));
    for (const bool known : {true, false}) {
      if (!known) cloud.viewpoint = Eigen::Vector3d::Zero();
      const RangeCheck check = check_range(cloud);
      CHECK(check.far == 0);
      CHECK(check.warning().empty());
      CHECK_FALSE(check.rest);
      CHECK(check.kept(CloudView(cloud)).points.data() == cloud.points.data());
      CHECK(&check.kept(cloud) == &cloud);
    }
    cloud.viewpoint.setConstant(NAN);
    CHECK(check_range(cloud).far == 0);
  }
}

TEST_CASE("codes for missing points leave gaps in images and go from lists", "[range][hostile]") {
  for (const float code : kMissingCodes) {
    CAPTURE(code);
    const PointCloud coded = with_code(table_cloud(), code), holed = with_gaps(table_cloud());
    const RangeCheck check = check_range(coded);
    CHECK(check.near == check_range(holed).near);
    CHECK(check_range(holed).far == 0);
    const CloudView kept = check.kept(CloudView(coded));
    REQUIRE(kept.points.size() == holed.points.size());
    CHECK(kept.width == coded.width);
    CHECK(kept.height == coded.height);
    CHECK(kept.viewpoint == coded.viewpoint);
    for (std::size_t i = 0; i < holed.points.size(); ++i) {
      const bool missing = !holed.points[i].allFinite();
      REQUIRE(missing == !kept.points[i].allFinite());
      if (!missing) REQUIRE(kept.points[i] == holed.points[i]);
    }
    if (!std::isfinite(code)) continue;
    const PointCloud list = as_list(coded), short_list = as_list(holed);
    const RangeCheck list_check = check_range(list);
    CHECK(list_check.near == short_list.points.size());
    CHECK(list_check.kept(list).points.size() == list.points.size() - list_check.far);
  }
}

TEST_CASE("how many points are left out is told", "[range]") {
  PointCloud cloud = table_cloud();
  cloud.points[0].setConstant(1e30f);
  CHECK(check_range(cloud).warning().starts_with("1 point farther than 1 km"));
  cloud.points[7].setConstant(-1001.0f);
  CHECK(check_range(cloud).warning().starts_with("2 points farther than 1 km"));
}

TEST_CASE("a cloud of codes alone has no point in range, or nothing but them", "[range][hostile]") {
  PointCloud cloud;
  cloud.points.assign(49, Eigen::Vector3f::Constant(1e30f));
  CHECK(check_range(cloud).near == 0);
  CHECK(check_range(cloud).far == 49);
  CHECK(check_range(PointCloud()).near == 0);
  CHECK_FALSE(check_range(PointCloud()).rest);
}
