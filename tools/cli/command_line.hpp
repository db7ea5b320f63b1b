#pragma once

#include <string>

namespace quadrille {

/// The command line of this process as a shell takes it; empty where the system does not tell.
std::string command_line();

}  // namespace quadrille
