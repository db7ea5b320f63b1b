#pragma once

#include <functional>
#include <string>

#include "quadrille/bus/event_log.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Gets one event of a log, with the time at which it was logged; its data lives until it returns.
using EventHandler = std::function<void(const LogReader::Event&)>;

/// Hands every whole event of a log to the handler, in order and none skipped, whatever bytes its
/// channel's name has (LCM's file provider passes over those that are no UTF-8). Ends at the end of
/// the log, or when a stop is requested.
/// @return what the log's headers say; its defect tells of a log that was cut short, also while it
///   was read
/// @throws std::runtime_error as survey_log() does; and what the handler throws
QUADRILLE_EXPORT LogSurvey replay_log(const std::string& path, const EventHandler& handler);

}  // namespace quadrille::bus
