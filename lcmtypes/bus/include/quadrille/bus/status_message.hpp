#pragma once

#include <cstddef>
#include <lcmtypes/quadrille/count_t.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/bus/rejection.hpp"

namespace quadrille::bus {

/// The refusals as a message: one entry for each reason that occurred.
std::vector<count_t> to_message(const RejectCounts& counts);

/// Who sent a status message of any process, as printable text; nullopt if the bytes are none.
std::optional<std::string> read_status_sender(std::span<const std::byte> bytes);

}  // namespace quadrille::bus
