#include "process/planner/recent_pairs.hpp"

#include "support/catch.hpp"

namespace quadrille {
namespace {

TEST_CASE("pairs are kept within their bounds, the newest always", "[process][request]") {
  const auto pair = [](std::int64_t utime, std::size_t points) {
    auto cloud = std::make_shared<bus::CloudMessage>();
    cloud->utime = utime;
    cloud->cloud.points.resize(points);
    auto made = std::make_shared<CloudAndQuadrics>();
    made->cloud = cloud;
    return made;
  };
  RecentPairs pairs(3, 1200);
  CHECK(pairs.newest() == nullptr);
  for (int k = 1; k <= 5; ++k) pairs.add(pair(k, 10));
  CHECK(pairs.size() == 3);
  CHECK(pairs.find(2) == nullptr);
  CHECK(pairs.find(3)->cloud->utime == 3);
  pairs.add(pair(6, 1000));
  CHECK(pairs.size() == 1);
  CHECK(pairs.newest()->cloud->utime == 6);
}

}  // namespace
}  // namespace quadrille
