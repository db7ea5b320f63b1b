#pragma once

namespace quadrille::bus {

/// Makes SIGINT and SIGTERM request a clean end instead of killing the process.
void install_stop_signals();

/// True once one of the signals came or request_stop() was called.
bool stop_requested();

/// Requests the end from within the process; may be called from any thread.
void request_stop();

}  // namespace quadrille::bus
