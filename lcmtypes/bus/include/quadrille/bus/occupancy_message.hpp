#pragma once

#include <cstddef>
#include <lcmtypes/quadrille/occupancy_t.hpp>
#include <span>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Reads a map of space from a message of type quadrille.occupancy_t. Every length is checked
/// before the generated decoder sees the bytes; the content of its data is not checked.
/// @param bytes      the message as it came, fingerprint first
/// @param max_bytes  larger messages are refused [byte]
QUADRILLE_EXPORT Decoded<occupancy_t> decode_occupancy(std::span<const std::byte> bytes,
                                                       std::size_t max_bytes = kMaxMessageBytes);

}  // namespace quadrille::bus
