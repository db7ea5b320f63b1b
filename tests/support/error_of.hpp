#pragma once

#include <exception>
#include <string>

namespace quadrille::test {

/// The message that a call throws; empty if it throws nothing.
template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace quadrille::test
