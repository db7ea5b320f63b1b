#pragma once

#include <cstddef>
#include <cstdint>
#include <lcmtypes/quadrille/bodies_t.hpp>
#include <span>
#include <string>
#include <vector>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/body.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// The bodies of one cloud, as received in a message.
struct BodiesMessage {
  /// Time of the cloud [us].
  std::int64_t utime = 0;
  /// Number of the cloud; 0 if the cloud has none.
  std::int32_t seq = 0;
  /// Name of the cloud's frame C.
  std::string frame;
  std::vector<SceneBody> bodies;
};

/// Makes the message of one body; its field `pose` is X_CB.
QUADRILLE_EXPORT body_t to_message(const SceneBody& body);

/// Makes the message of the bodies, stamped with their cloud's utime, seq and frame.
QUADRILLE_EXPORT bodies_t to_message(const CloudMessage& cloud,
                                     const std::vector<SceneBody>& bodies);

/// Reads bodies from a message of type quadrille.bodies_t. Every length and value is checked before
/// the generated decoder sees the bytes.
/// @param bytes      the message as it came, fingerprint first
/// @param max_bytes  larger messages are refused [byte]
QUADRILLE_EXPORT Decoded<BodiesMessage> decode_bodies(std::span<const std::byte> bytes,
                                                      std::size_t max_bytes = kMaxQuadricsBytes);

}  // namespace quadrille::bus
