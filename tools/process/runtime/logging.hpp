#pragma once

#include <string>

namespace quadrille {

/// Sends the records of a process to stderr, one per line, with time, program and level.
/// @param program  name of the program in the records
/// @param verbose  whether records of log_debug() are sent too
void start_logging(const std::string& program, bool verbose);

void log_debug(const std::string& record);
void log_info(const std::string& record);
void log_warning(const std::string& record);
void log_error(const std::string& record);

}  // namespace quadrille
