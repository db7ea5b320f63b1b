#pragma once

#include <functional>
#include <string>

#include "quadrille/bus/event_log.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Receives one event of a log with the time at which it was logged; its data are valid until it
/// returns.
using EventHandler = std::function<void(const LogReader::Event&)>;

/// Hands every complete event of a log to the handler in order, whatever bytes its channel's name
/// has (LCM's file provider skips names that are not UTF-8). Ends at the end of the log, or when a
/// stop is requested.
/// @return survey of the log's headers; its defect is also set if the log was truncated while it
///   was read
/// @throws std::runtime_error like survey_log(), and whatever the handler throws
QUADRILLE_EXPORT LogSurvey replay_log(const std::string& path, const EventHandler& handler);

}  // namespace quadrille::bus
