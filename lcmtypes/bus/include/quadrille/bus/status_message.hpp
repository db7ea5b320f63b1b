#pragma once

#include <lcmtypes/quadrille/count_t.hpp>
#include <vector>

#include "quadrille/bus/rejection.hpp"

namespace quadrille::bus {

/// The refusals as a message: one entry for each reason that occurred.
std::vector<count_t> to_message(const RejectCounts& counts);

}  // namespace quadrille::bus
