#pragma once

#include <string>

#include "lab/bench/contender.hpp"

namespace quadrille::bench {

/// Runs a peer's program on a frame. Peers are separate programs, so that neither their libraries
/// nor their licences become ours.
/// @throws std::runtime_error naming the program if it fails
Outcome run_program_on(const std::string& program, const Frame& frame);

}  // namespace quadrille::bench
