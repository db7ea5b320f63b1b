#pragma once

#include <string>
#include <vector>

namespace quadrille::bench {

/// Runs another program and waits until it ends.
/// @param words  the program, which is looked for in PATH if its name has no slash, and its
///               arguments
/// @return true if it could be started and ended with exit code 0
bool run_process(std::vector<std::string> words);

}  // namespace quadrille::bench
