#include "process/planner/recent_messages.hpp"

#include "quadrille/bus/boxes_message.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

bus::BoxesMessage boxes_of(std::int64_t utime, int id, int seq = 0) {
  Box box;
  box.id = id;
  return {utime, seq, "camera", {box}};
}

bus::QuadricsMessage quadrics_at(std::int64_t utime, int seq = 0) {
  bus::QuadricsMessage quadrics;
  quadrics.utime = utime;
  quadrics.seq = seq;
  quadrics.frame = "camera";
  return quadrics;
}

TEST_CASE("quadrics get the boxes with their stamps, once", "[process][planner]") {
  RecentMessages<bus::BoxesMessage> recent;
  for (const int k : {1, 2, 3}) recent.add(boxes_of(100 * k, k));
  CHECK_FALSE(recent.take(quadrics_at(150)));
  CHECK_FALSE(recent.take(quadrics_at(200, 7)));
  const auto boxes = recent.take(quadrics_at(200));
  REQUIRE(boxes);
  REQUIRE(boxes->boxes.size() == 1);
  CHECK(boxes->boxes.front().id == 2);
  CHECK_FALSE(recent.take(quadrics_at(200)));
  // Older boxes are forgotten, later ones are not.
  CHECK_FALSE(recent.take(quadrics_at(100)));
  CHECK(recent.take(quadrics_at(300)));
}

TEST_CASE("of boxes with equal stamps the newest belong to the quadrics that come next",
          "[process][planner]") {
  RecentMessages<bus::BoxesMessage> recent;
  // The quadrics of the first were lost.
  recent.add(boxes_of(0, 1));
  recent.add(boxes_of(0, 2));
  CHECK(recent.take(quadrics_at(0)).value().boxes.front().id == 2);
  CHECK_FALSE(recent.take(quadrics_at(0)));
}

TEST_CASE("boxes without quadrics are kept only for so many clouds", "[process][planner]") {
  RecentMessages<bus::BoxesMessage> recent;
  for (int k = 0; k < 100; ++k) recent.add(boxes_of(k, k));
  CHECK_FALSE(recent.take(quadrics_at(0)));
  CHECK(recent.take(quadrics_at(99)));
}

}  // namespace
}  // namespace quadrille
