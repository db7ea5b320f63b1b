#pragma once

#include <string>

#include "support/catch.hpp"

namespace quadrille::test {

/// Matches text with that part; its name differs between Catch2 v2 and v3.
inline auto contains(const std::string& part) {
#if __has_include(<catch2/catch_all.hpp>)
  return Catch::Matchers::ContainsSubstring(part);
#else
  return Catch::Matchers::Contains(part);
#endif
}

}  // namespace quadrille::test
