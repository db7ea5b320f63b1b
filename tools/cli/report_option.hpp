#pragma once

#include <string>

namespace CLI {
class App;
}

namespace quadrille {

/// Adds --report-html, which refuses a path that is not that of a page before any work is done; the
/// path must outlive the app.
/// @param what  what the page shows, such as "the clouds and the quadrics"
void add_report_option(CLI::App& command, std::string& path, const std::string& what);

}  // namespace quadrille
