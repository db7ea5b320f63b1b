#pragma once

/// Marks the functions that a shared library shows; all others are hidden in it.
#define QUADRILLE_EXPORT __attribute__((visibility("default")))
