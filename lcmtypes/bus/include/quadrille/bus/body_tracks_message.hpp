#pragma once

#include <cstddef>
#include <cstdint>
#include <lcmtypes/quadrille/body_tracks_t.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/body.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// The tracks of the bodies of one cloud, as received in a message.
struct BodyTracksMessage {
  /// Time of the cloud [us].
  std::int64_t utime = 0;
  /// Number of the cloud; 0 if the cloud has none.
  std::int32_t seq = 0;
  /// Name of the cloud's frame C.
  std::string frame;
  /// The track of each body that has one, by the body's id.
  std::map<int, int> track_of;
};

/// Makes the message of the tracks of those bodies that have one, stamped with their cloud's utime,
/// seq and frame.
QUADRILLE_EXPORT body_tracks_t tracks_message(const CloudMessage& cloud,
                                              const std::vector<SceneBody>& bodies);

/// Gives each body its track; those that the message does not name have none.
QUADRILLE_EXPORT void set_tracks(const BodyTracksMessage& message, std::vector<SceneBody>* bodies);

/// Reads tracks from a message of type quadrille.body_tracks_t. Every length and value is checked
/// before the generated decoder sees the bytes.
/// @param bytes      the message as it came, fingerprint first
/// @param max_bytes  larger messages are refused [byte]
QUADRILLE_EXPORT Decoded<BodyTracksMessage> decode_body_tracks(
    std::span<const std::byte> bytes, std::size_t max_bytes = kMaxQuadricsBytes);

}  // namespace quadrille::bus
