#include "process/planner/pairing.hpp"

#include "support/catch.hpp"

namespace quadrille {
namespace {

bus::CloudMessage make_cloud(std::int64_t utime, std::size_t points = 1) {
  bus::CloudMessage message;
  message.utime = utime;
  message.cloud.points.resize(points);
  return message;
}

bus::QuadricsMessage make_quadrics(std::int64_t utime) { return {utime, 0, "", {}}; }

TEST_CASE("quadrics meet the cloud of their utime, though newer clouds came",
          "[planner][pairing]") {
  Pairing pairing;
  for (int utime = 1; utime <= 5; ++utime) CHECK_FALSE(pairing.add(make_cloud(utime)));
  const auto pair = pairing.add(make_quadrics(3));
  REQUIRE(pair);
  CHECK(pair->cloud->utime == 3);
  CHECK(pair->quadrics.utime == 3);
  // Older clouds are forgotten, newer ones are not.
  CHECK_FALSE(pairing.add(make_quadrics(2)));
  CHECK(pairing.add(make_quadrics(5)));
  CHECK(pairing.paired() == 2);
  CHECK(pairing.unpaired() == 1);
}

TEST_CASE("quadrics that come before their cloud wait for it", "[planner][pairing]") {
  Pairing pairing;
  CHECK_FALSE(pairing.add(make_quadrics(7)));
  CHECK(pairing.unpaired() == 1);
  CHECK_FALSE(pairing.add(make_cloud(6)));
  CHECK(pairing.add(make_cloud(7)));
  CHECK(pairing.unpaired() == 0);
  CHECK(pairing.paired() == 1);
}

TEST_CASE("quadrics of another seq or frame belong to another cloud", "[planner][pairing]") {
  Pairing pairing;
  pairing.add(make_cloud(1));
  CHECK_FALSE(pairing.add(bus::QuadricsMessage{1, 9, "", {}}));
  CHECK_FALSE(pairing.add(bus::QuadricsMessage{1, 0, "other", {}}));
  CHECK(pairing.unpaired() == 2);
}

TEST_CASE("no more clouds are kept than allowed, by number and by memory", "[planner][pairing]") {
  Pairing few(2);
  for (int utime = 1; utime <= 3; ++utime) few.add(make_cloud(utime));
  CHECK_FALSE(few.add(make_quadrics(1)));
  CHECK(few.add(make_quadrics(2)));
  Pairing small(100, 1200);
  for (int utime = 1; utime <= 3; ++utime) small.add(make_cloud(utime, 50));
  CHECK_FALSE(small.add(make_quadrics(1)));
  CHECK(small.add(make_quadrics(2)));
  // The newest is kept though it is too large.
  small.add(make_cloud(9, 1000));
  CHECK(small.add(make_quadrics(9)));
  CHECK_THROWS_AS(Pairing(0), std::invalid_argument);
}

}  // namespace
}  // namespace quadrille
