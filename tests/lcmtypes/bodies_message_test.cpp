#include "quadrille/bus/bodies_message.hpp"

#include <limits>

#include "cloud_samples.hpp"
#include "decoders.hpp"
#include "found_samples.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/detector/detection.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("bodies survive their message", "[bus][bodies]") {
  const std::vector<SceneBody> sent = test::make_bodies();
  const auto decoded = decode_bodies(encode(to_message(test::make_cloud(), sent)));
  REQUIRE(std::holds_alternative<BodiesMessage>(decoded));
  const auto& got = std::get<BodiesMessage>(decoded);
  CHECK(got.utime == 1234567);
  CHECK(got.seq == 42);
  CHECK(got.frame == "camera");
  REQUIRE(got.bodies.size() == sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const SceneBody &a = sent[i], &b = got.bodies[i];
    CHECK(b.id == a.id);
    CHECK(b.kind == a.kind);
    CHECK(b.parts == a.parts);
    CHECK(b.X_CB.matrix() == rounded(a.X_CB).matrix());
    CHECK(b.size == a.size);
    CHECK(b.std == a.std);
    CHECK(b.seen == a.seen);
    REQUIRE(b.wall.has_value() == a.wall.has_value());
    if (a.wall) CHECK(b.wall->thickness == a.wall->thickness);
    if (a.wall) CHECK(b.wall->std == a.wall->std);
    CHECK(b.standing_on == a.standing_on);
    CHECK(b.points == a.points);
    CHECK(b.views == a.views);
    CHECK(b.unseen == a.unseen);
  }
}

TEST_CASE("bodies with values without meaning are refused", "[bus][bodies][hostile]") {
  const bodies_t valid = to_message(test::make_cloud(), test::make_bodies());
  bodies_t kind = valid, nan = valid, infinite = valid, unseen = valid, invisible = valid;
  bodies_t wall = valid, no_wall = valid;
  kind.bodies[0].kind = 4;
  nan.bodies[1].std[0] = std::numeric_limits<double>::quiet_NaN();
  infinite.bodies[0].size[1] = std::numeric_limits<double>::infinity();
  unseen.bodies[0].unseen = -1.0;
  invisible.bodies[1].views = 0;
  wall.bodies[0].wall_std = std::numeric_limits<double>::quiet_NaN();
  no_wall.bodies[0].wall = 0.0;
  for (const bodies_t& bad : {kind, nan, infinite, unseen, invisible, wall, no_wall}) {
    CHECK(test::refusal_in(decode_bodies(encode(bad))) == RejectReason::kBadValue);
  }
}

}  // namespace
}  // namespace quadrille::bus
