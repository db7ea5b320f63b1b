#pragma once

#include <chrono>
#include <string>

#include "cli/process_arguments.hpp"
#include "process/runtime/node.hpp"

namespace quadrille {

/// Runs the node of a process as its command line asks: on the bus or through a log.
/// @param name  name of the program in log records
/// @throws std::runtime_error if the bus or a log cannot be used, or a job failed in replay
void run_process(const std::string& name, const ProcessArguments& arguments,
                 const NodeMaker& make_node);

/// Time that the current job may take after a stop was requested. Then it is given up with the
/// process, which has to end within a second.
inline constexpr std::chrono::milliseconds kStopPatience{600};

/// Works on the bus until a stop is requested.
void run_on_bus(const ProcessArguments& arguments, const NodeMaker& make_node);

/// Works through a log: processes every event in order, skipping none.
/// @throws std::runtime_error if a log cannot be used, a job failed, or a signal stopped it before
///   the end of the log
void run_on_log(const ProcessArguments& arguments, const NodeMaker& make_node);

}  // namespace quadrille
