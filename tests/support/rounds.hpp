#pragma once

#include <algorithm>
#include <cstdlib>

namespace quadrille::test {

/// How many times as much a test of random cases is to do: QUADRILLE_TEST_ROUNDS, 1 if it is not
/// set.
inline int rounds() {
  const char* text = std::getenv("QUADRILLE_TEST_ROUNDS");
  return text ? std::max(1, std::atoi(text)) : 1;
}

}  // namespace quadrille::test
