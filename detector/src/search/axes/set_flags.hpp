#pragma once

namespace quadrille {

/// Lists the places of the flags that are one among flags that are zero or one, in ascending
/// order. It takes no branches, which would often be mispredicted.
/// @param list  with room for all flags
/// @return number of places
inline int list_set_flags(const int* flags, int size, int* list) {
  int count = 0;
  for (int i = 0; i < size; ++i) {
    list[count] = i;
    count += flags[i];
  }
  return count;
}

}  // namespace quadrille
