#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace quadrille {

/// Tells of a program's options in place of working: what manual pages and the shells' completion
/// are made of. A program does so where the environment has QUADRILLE_DESCRIBE.
/// @param how    "manual": the manual page, as roff; "complete": what the last word may become, a
/// line
///               each with its meaning after a tab
/// @param words  the command line after the program's name
/// @return the text; empty for an unknown `how`
std::string describe_program(const CLI::App& app, const std::string& how,
                             const std::vector<std::string>& words);

}  // namespace quadrille
