#pragma once

#include <string>

namespace CLI {
class App;
}

namespace quadrille {

/// Adds --picture FILE.png, which refuses other endings before any work is done.
/// @param path  gets the file; must outlive the app
/// @param what  what is drawn, such as "the cloud and the quadrics"
void add_picture_option(CLI::App& command, std::string& path, const std::string& what);

}  // namespace quadrille
