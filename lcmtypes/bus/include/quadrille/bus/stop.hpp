#pragma once

namespace quadrille::bus {

/// Makes SIGINT and SIGTERM ask for a clean end instead of killing the process.
void install_stop_signals();

/// True once one of the signals came, or request_stop() was called.
bool stop_requested();

/// Asks for the end from within the process, from any thread.
void request_stop();

}  // namespace quadrille::bus
