#pragma once

#include <cstdint>
#include <lcmtypes/quadrille/count_t.hpp>
#include <lcmtypes/quadrille/transport_t.hpp>
#include <string>
#include <vector>

#include "link/connection.hpp"
#include "process/runtime/node.hpp"
#include "process/runtime/status/process_info.hpp"
#include "process/runtime/status/stages.hpp"
#include "run/clock.hpp"

namespace quadrille {

/// Returns the part of the status messages that describes the transport of messages into the
/// process.
transport_t to_message(const bus::Traffic& traffic);

/// Returns "no_cloud 2, other_cloud 1".
std::string list_counts(const std::vector<count_t>& counts);

/// Fills in the fields that the status messages of all nodes have in common.
/// @param settings  value of SettingsText::hash()
template <class Status>
void write_common(const RunState& run, const std::string& settings, Status* status) {
  status->utime = bus::wall_clock_utime();
  status->superseded = run.superseded;
  status->transport = to_message(run.traffic);
  status->process = describe_process(settings);
  status->warnings = run.warnings;
  status->num_warnings = static_cast<std::int32_t>(run.warnings.size());
}

template <class Status>
void set_stages(const Stages& stages, Status* status) {
  status->stages = stages.to_message();
  status->num_stages = static_cast<std::int32_t>(status->stages.size());
}

}  // namespace quadrille
