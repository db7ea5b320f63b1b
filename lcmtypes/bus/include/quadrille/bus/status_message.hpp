#pragma once

#include <cstddef>
#include <lcmtypes/quadrille/count_t.hpp>
#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Makes the message of the refusals, with one entry for each reason that occurred.
QUADRILLE_EXPORT std::vector<count_t> to_message(const RejectCounts& counts);

/// Returns the sender of a status message of any process as printable text; nullopt if the bytes
/// are no status message.
QUADRILLE_EXPORT std::optional<std::string> read_status_sender(std::span<const std::byte> bytes);

/// Reads the status of a detector from a message of type quadrille.detector_status_t. Every length
/// is checked before the generated decoder sees the bytes; other numbers are not checked.
/// @param bytes  the message as it came, fingerprint first
QUADRILLE_EXPORT Decoded<detector_status_t> decode_detector_status(
    std::span<const std::byte> bytes);

/// Reads the status of a planner from a message of type quadrille.planner_status_t in the same way.
QUADRILLE_EXPORT Decoded<planner_status_t> decode_planner_status(std::span<const std::byte> bytes);

}  // namespace quadrille::bus
