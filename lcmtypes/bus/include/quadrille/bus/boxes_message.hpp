#pragma once

#include <cstddef>
#include <cstdint>
#include <lcmtypes/quadrille/boxes_t.hpp>
#include <span>
#include <string>
#include <vector>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// The boxes of one cloud, as received in a message.
struct BoxesMessage {
  /// Time of the cloud [us].
  std::int64_t utime = 0;
  /// Number of the cloud; 0 if the cloud has none.
  std::int32_t seq = 0;
  /// Name of the cloud's frame C.
  std::string frame;
  std::vector<Box> boxes;
};

/// Makes the message of one box; its field `pose` is X_CB.
QUADRILLE_EXPORT box_t to_message(const Box& box);

/// Makes the message of the boxes, stamped with their cloud's utime, seq and frame.
QUADRILLE_EXPORT boxes_t to_message(const CloudMessage& cloud, const std::vector<Box>& boxes);

/// Reads boxes from a message of type quadrille.boxes_t. Every length and value is checked before
/// the generated decoder sees the bytes.
/// @param bytes      the message as it came, fingerprint first
/// @param max_bytes  larger messages are refused [byte]
QUADRILLE_EXPORT Decoded<BoxesMessage> decode_boxes(std::span<const std::byte> bytes,
                                                    std::size_t max_bytes = kMaxQuadricsBytes);

}  // namespace quadrille::bus
