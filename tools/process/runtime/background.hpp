#pragma once

namespace quadrille {

/// Leaves signals to the main thread, and lets the calling thread, and those that it starts, yield
/// to others by so much more, as nice does.
void go_to_background(int niceness);

}  // namespace quadrille
