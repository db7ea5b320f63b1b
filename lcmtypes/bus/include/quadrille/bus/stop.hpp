#pragma once

#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Makes SIGINT and SIGTERM request a clean end instead of killing the process.
QUADRILLE_EXPORT void install_stop_signals();

/// True once one of the signals came or request_stop() was called.
QUADRILLE_EXPORT bool stop_requested();

/// Requests the end from within the process; may be called from any thread.
QUADRILLE_EXPORT void request_stop();

}  // namespace quadrille::bus
