#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace quadrille {

/// Describes a program's options instead of running it; manual pages and the shells' completion are
/// made from this. Programs do so if the environment has QUADRILLE_DESCRIBE.
/// @param how  "manual" for the manual page, as roff; "complete" for what the last word may become,
/// one per line with its meaning after a tab
/// @param words  the command line after the program's name
/// @return the text; empty for an unknown `how`
std::string describe_program(const CLI::App& app, const std::string& how,
                             const std::vector<std::string>& words);

}  // namespace quadrille
