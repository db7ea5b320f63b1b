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

/// The refusals as a message: one entry for each reason that occurred.
QUADRILLE_EXPORT std::vector<count_t> to_message(const RejectCounts& counts);

/// Who sent a status message of any process, as printable text; nullopt if the bytes are none.
QUADRILLE_EXPORT std::optional<std::string> read_status_sender(std::span<const std::byte> bytes);

/// Reads how a detector fares out of a message of type quadrille.detector_status_t, with every
/// length checked before the generated decoder sees the bytes; numbers are as they came.
/// @param bytes  the message as it came, fingerprint first
QUADRILLE_EXPORT Decoded<detector_status_t> decode_detector_status(
    std::span<const std::byte> bytes);

/// The same for a planner and quadrille.planner_status_t.
QUADRILLE_EXPORT Decoded<planner_status_t> decode_planner_status(std::span<const std::byte> bytes);

}  // namespace quadrille::bus
