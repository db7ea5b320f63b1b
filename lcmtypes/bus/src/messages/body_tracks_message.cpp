#include "quadrille/bus/body_tracks_message.hpp"

#include <utility>

#include "messages/decode_checked.hpp"

namespace quadrille::bus {
namespace {

void check_body_track(ByteReader& reader) {
  reader.read_int32("id");
  const std::int32_t track = reader.read_int32("track");
  if (track < 1) refuse(RejectReason::kBadValue, "track " + std::to_string(track));
}

void check_body_tracks(ByteReader& reader) {
  check_stamped_list(reader, "num_tracks", 2 * sizeof(std::int32_t), check_body_track);
}

BodyTracksMessage from_body_tracks(body_tracks_t m) {
  BodyTracksMessage message{m.utime, m.seq, std::move(m.frame), {}};
  for (const body_track_t& body : m.tracks) message.track_of.emplace(body.id, body.track);
  return message;
}

}  // namespace

body_tracks_t tracks_message(const CloudMessage& cloud, const std::vector<SceneBody>& bodies) {
  auto m = stamped_as<body_tracks_t>(cloud);
  for (const SceneBody& body : bodies) {
    if (body.track == 0) continue;
    body_track_t& track = m.tracks.emplace_back();
    track.id = body.id;
    track.track = body.track;
  }
  m.num_tracks = static_cast<std::int32_t>(m.tracks.size());
  return m;
}

void set_tracks(const BodyTracksMessage& message, std::vector<SceneBody>* bodies) {
  for (SceneBody& body : *bodies) {
    const auto found = message.track_of.find(body.id);
    body.track = found == message.track_of.end() ? 0 : found->second;
  }
}

Decoded<BodyTracksMessage> decode_body_tracks(std::span<const std::byte> bytes,
                                              std::size_t max_bytes) {
  return decode_checked<body_tracks_t, BodyTracksMessage>(bytes, max_bytes, check_body_tracks,
                                                          from_body_tracks);
}

}  // namespace quadrille::bus
