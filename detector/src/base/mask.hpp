#pragma once

#include <vector>

namespace quadrille {

/// Selects elements of a list: nonzero for those to use, zero for those to leave out. An empty mask
/// selects all. It has bytes because vectors of bool are slow.
using Mask = std::vector<char>;

}  // namespace quadrille
