#include "quadrille/bus/boxes_message.hpp"

#include "cloud_samples.hpp"
#include "found_samples.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("boxes survive their message", "[bus][boxes]") {
  const auto decoded = decode_boxes(encode(to_message(test::make_cloud(), test::make_boxes())));
  REQUIRE(std::holds_alternative<BoxesMessage>(decoded));
  const auto& got = std::get<BoxesMessage>(decoded);
  CHECK(got.utime == 1234567);
  CHECK(got.seq == 42);
  CHECK(got.frame == "camera");
  const std::vector<Box> sent = test::make_boxes();
  REQUIRE(got.boxes.size() == sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const Box &a = sent[i], &b = got.boxes[i];
    CHECK(b.id == a.id);
    CHECK(b.faces == a.faces);
    CHECK(b.score == a.score);
    CHECK(b.X_CB.matrix() == rounded(a.X_CB).matrix());
    CHECK(b.size == a.size);
    CHECK(b.std == a.std);
    CHECK(b.seen == a.seen);
    CHECK(b.inner_B.isApprox(a.inner_B, 0.0));
    CHECK(b.outer_B.isApprox(a.outer_B, 0.0));
  }
}

}  // namespace
}  // namespace quadrille::bus
