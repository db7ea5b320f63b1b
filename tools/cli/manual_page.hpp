#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace quadrille {

/// Returns the manual page of a program or one of its commands, as roff with the macros of man(7).
/// The date is written as @DATE@.
/// @param words  the command, such as {"study", "grasps"}; empty for the program
/// @throws std::invalid_argument for an unknown command
std::string manual_page(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace quadrille
