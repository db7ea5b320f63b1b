#include "quadrille/detector/options.hpp"

#include <stdexcept>
#include <string>

namespace quadrille {

void DetectorOptions::check() const {
  if (threads < 1 || threads > 256) {
    throw std::invalid_argument("threads = " + std::to_string(threads) +
                                ": must lie between 1 and 256");
  }
}

}  // namespace quadrille
