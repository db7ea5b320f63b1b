#pragma once

#include <string>

namespace quadrille {

/// Returns the command line of this process in the form that a shell accepts; empty if the system
/// does not reveal it.
std::string command_line();

}  // namespace quadrille
