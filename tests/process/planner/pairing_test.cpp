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

bus::CloudMessage make_cloud_of(std::int64_t digest, std::int64_t utime = 0) {
  bus::CloudMessage message = make_cloud(utime);
  message.digest = digest;
  return message;
}

bus::QuadricsMessage make_quadrics_of(std::int64_t digest, std::int64_t utime = 0) {
  return {utime, 0, "", {}, digest};
}

TEST_CASE("where all clouds have one utime, quadrics meet the cloud of their points",
          "[planner][pairing]") {
  Pairing pairing;
  // Two scenes in turns, and a detector that is slow and skips some.
  for (const int scene : {1, 2, 1, 2}) pairing.add(make_cloud_of(scene));
  auto pair = pairing.add(make_quadrics_of(1));
  REQUIRE(pair);
  CHECK(pair->cloud->digest == 1);
  pairing.add(make_cloud_of(1));
  pair = pairing.add(make_quadrics_of(2));
  REQUIRE(pair);
  CHECK(pair->cloud->digest == 2);
  CHECK_FALSE(pairing.add(make_quadrics_of(3)));
  CHECK(pairing.unpaired(Unpaired::kOtherCloud) == 1);
  pair = pairing.add(make_cloud_of(3));
  REQUIRE(pair);
  CHECK(pair->cloud->digest == 3);
  CHECK(pairing.paired() == 3);
  CHECK(pairing.unpaired() == 0);
}

TEST_CASE("each of some clouds with the same points has its quadrics", "[planner][pairing]") {
  Pairing pairing;
  for (int n = 0; n < 3; ++n) pairing.add(make_cloud_of(5));
  for (int n = 0; n < 3; ++n) CHECK(pairing.add(make_quadrics_of(5)));
  CHECK(pairing.unpaired() == 0);
}

TEST_CASE("quadrics without a digest meet the only cloud of their utime, and none of several",
          "[planner][pairing]") {
  Pairing pairing;
  pairing.add(make_cloud_of(1, 10));
  CHECK(pairing.add(make_quadrics(10)));
  for (const int scene : {1, 2}) pairing.add(make_cloud_of(scene, 20));
  CHECK_FALSE(pairing.add(make_quadrics(20)));
  CHECK(pairing.unpaired(Unpaired::kAmbiguous) == 1);
  const auto given_up = pairing.take_given_up();
  REQUIRE(given_up);
  CHECK(given_up->utime == 20);
  CHECK_FALSE(pairing.take_given_up());
  // Nor does it wait for a third.
  CHECK_FALSE(pairing.add(make_cloud_of(3, 20)));
}

TEST_CASE("quadrics without a cloud are counted by reason", "[planner][pairing]") {
  Pairing pairing;
  pairing.add(make_cloud_of(1, 10));
  pairing.add(make_quadrics_of(1, 5));
  pairing.add(make_quadrics_of(2, 10));
  const std::vector<count_t> counts = pairing.count_unpaired();
  REQUIRE(counts.size() == 2);
  CHECK(counts[0].name == std::string("no_cloud"));
  CHECK(counts[1].name == std::string("other_cloud"));
  CHECK(counts[0].count + counts[1].count == pairing.unpaired());
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
