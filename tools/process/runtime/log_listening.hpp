#pragma once

#include <string>
#include <vector>

#include "quadrille/bus/connection.hpp"

namespace quadrille {

/// Logs on which channels a process listens, and with which receive buffer, after subscribing.
/// @param url  address as it was given; the buffer in use is what the kernel grants
void log_listening(const std::vector<std::string>& channels, const std::string& url,
                   const bus::Connection& connection);

}  // namespace quadrille
