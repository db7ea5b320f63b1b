#pragma once

#include <cstddef>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <span>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Reads grasps from a message of type quadrille.grasps_t. Every length is checked before the
/// generated decoder sees the bytes. Proposed views must have sound poses and finite gains; other
/// numbers are not checked. The field `pose` of a grasp is X_CG, that of a proposed view X_CK.
/// @param bytes      the message as it came, fingerprint first
/// @param max_bytes  larger messages are refused [byte]
QUADRILLE_EXPORT Decoded<grasps_t> decode_grasps(std::span<const std::byte> bytes,
                                                 std::size_t max_bytes = kMaxMessageBytes);

}  // namespace quadrille::bus
