#pragma once

#include "settings.hpp"

namespace quadrille {

/// Reads the command line, and the configuration file that it names.
/// Ends the process where the command line is wrong (2) or only asks for help (0).
DetectorSettings parse_command_line(int argc, const char* const* argv);

}  // namespace quadrille
