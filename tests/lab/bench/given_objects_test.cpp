#include "lab/bench/given_objects.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/known_frame.hpp"

namespace quadrille::bench {
namespace {

std::size_t count_labels(const scoring::Frame& frame, int label) {
  return static_cast<std::size_t>(std::count(frame.labels.begin(), frame.labels.end(), label));
}

TEST_CASE("each body with a curved surface is an object, and a wall is none", "[bench][objects]") {
  const scoring::Frame frame = test::make_known_frame();
  const std::vector<PointCloud> objects = given_objects(frame);
  REQUIRE(objects.size() == 2);
  CHECK(objects[0].points.size() == count_labels(frame, 0));
  CHECK(objects[1].points.size() == count_labels(frame, 2));
}

TEST_CASE("an object has the points of all surfaces of its body", "[bench][objects]") {
  scoring::Frame frame = test::make_known_frame();
  frame.surfaces[2].body = frame.surfaces[0].body;
  frame.labels[0] = -2;
  const std::vector<PointCloud> objects = given_objects(frame);
  REQUIRE(objects.size() == 1);
  CHECK(objects[0].points.size() == count_labels(frame, 0) + count_labels(frame, 2));
  CHECK(given_objects({}).empty());
}

}  // namespace
}  // namespace quadrille::bench
