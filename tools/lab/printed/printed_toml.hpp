#pragma once

#include <string_view>

namespace quadrille::printed {

/// The text of printed.toml, which is built into the program.
std::string_view printed_toml();

}  // namespace quadrille::printed
