#pragma once

#include <string_view>

namespace quadrille::bench {

/// The text of speed.json, which is built into the program.
std::string_view speed_json();

/// The compiler, its version and the settings that change its instructions.
std::string_view compiler();

}  // namespace quadrille::bench
