#include "quadrille/bus/body_tracks_message.hpp"

#include "cloud_samples.hpp"
#include "decoders.hpp"
#include "found_samples.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

TEST_CASE("the tracks of bodies survive their message", "[bus][bodies][track]") {
  std::vector<SceneBody> sent = test::make_bodies();
  REQUIRE(sent.size() >= 2);
  sent[0].track = 7;
  const auto decoded = decode_body_tracks(encode(tracks_message(test::make_cloud(), sent)));
  REQUIRE(std::holds_alternative<BodyTracksMessage>(decoded));
  const auto& got = std::get<BodyTracksMessage>(decoded);
  CHECK(got.utime == 1234567);
  CHECK(got.seq == 42);
  CHECK(got.frame == "camera");
  std::vector<SceneBody> bodies = test::make_bodies();
  bodies[1].track = 3;
  set_tracks(got, &bodies);
  CHECK(bodies[0].track == 7);
  // The message has none for it.
  CHECK(bodies[1].track == 0);
}

TEST_CASE("tracks of bodies that are no numbers of theirs are refused", "[bus][bodies][hostile]") {
  std::vector<SceneBody> bodies = test::make_bodies();
  bodies[0].track = 1;
  body_tracks_t bad = tracks_message(test::make_cloud(), bodies);
  bad.tracks[0].track = 0;
  CHECK(test::refusal_in(decode_body_tracks(encode(bad))) == RejectReason::kBadValue);
}

}  // namespace
}  // namespace quadrille::bus
