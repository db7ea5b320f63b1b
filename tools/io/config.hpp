#pragma once

#include <string>

#include "quadrille/detector/options.hpp"

namespace quadrille::io {

/// Reads the detector's settings from a TOML file; what the file leaves out keeps its default.
/// @throws FileError naming line and key if the file is missing or no TOML, if a key is unknown, or
///         if a value has the wrong type or is out of range
DetectorOptions load_detector_options(const std::string& path);

/// The defaults as a commented TOML file, from which load_detector_options reads them back.
std::string default_detector_config();

}  // namespace quadrille::io
