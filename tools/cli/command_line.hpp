#pragma once

#include <string>

namespace quadrille {

/// Returns a word, in quotes if a shell needs them.
std::string in_quotes(const std::string& word);

/// Returns the command line of this process in the form that a shell accepts; empty if the system
/// does not reveal it.
std::string command_line();

}  // namespace quadrille
