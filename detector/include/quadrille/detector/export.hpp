#pragma once

#if __cplusplus < 202002L
#error "quadrille's headers are C++20: compile with -std=c++20, or newer"
#endif

/// Marks the functions that a shared library exports; all others are hidden.
#define QUADRILLE_EXPORT __attribute__((visibility("default")))
