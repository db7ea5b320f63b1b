#pragma once

#include <string>
#include <string_view>

#include "lab/printed/printed_options.hpp"
#include "quadrille/detector/options.hpp"

namespace quadrille::printed {

/// All settings of a pipeline between the printed one and the detector, which is the default.
struct Settings {
  DetectorOptions detector;
  PrintedOptions printed;
};

/// Reads a TOML file with the detector's settings and the table [printed].
/// @throws io::FileError naming line and key if the file is missing or not TOML, if a key is
///   unknown, or if a value has the wrong type or is out of range
Settings load_settings(const std::string& path);

/// Like load_settings(), from the text of such a file.
/// @param path  name of the text in errors
Settings parse_settings(std::string_view text, const std::string& path);

/// The settings of the paper's printed pipeline, of the file printed.toml, which is built in.
Settings printed_settings();

}  // namespace quadrille::printed
