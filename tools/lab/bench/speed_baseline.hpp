#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "lab/bench/instructions.hpp"

namespace quadrille::bench {

/// The instructions that an earlier detector needed for some clouds.
struct SpeedBaseline {
  struct Cloud {
    /// Number of points; a cloud with another number is another cloud.
    std::size_t points = 0;
    /// By stage of the detector.
    Instructions stages;
  };

  /// The compiler and its settings, as built_by() tells them: the counts of others differ.
  std::string built_by;
  /// By the name of the cloud.
  std::map<std::string, Cloud> clouds;
};

/// Tells how this program was compiled, and whether the machine has AVX2, for which hot loops are
/// compiled separately.
std::string built_by();

/// Returns the baseline that is built into the program, of speed.json.
SpeedBaseline own_baseline();

/// Reads a baseline that to_json() has written.
/// @param path  name of the text in errors
/// @throws io::FileError naming the path if the text is no baseline
SpeedBaseline parse_baseline(std::string_view text, const std::string& path);

/// Reads a baseline from a file.
/// @throws io::FileError naming the file if it cannot be read or is no baseline
SpeedBaseline read_baseline(const std::string& path);

/// Returns the text of the baseline's file.
std::string to_json(const SpeedBaseline& baseline);

}  // namespace quadrille::bench
