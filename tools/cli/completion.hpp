#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace quadrille {

/// A word with which a command line may continue.
struct Completion {
  std::string word, meaning;
};

/// Returns what the last word of a command line may become: a command, an option, or a value of the
/// option before it. Empty if any text or a file is expected.
/// @param words  the command line after the program's name; the last one may be empty
std::vector<Completion> complete(const CLI::App& app, std::vector<std::string> words);

}  // namespace quadrille
