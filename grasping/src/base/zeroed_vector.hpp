#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace quadrille {

/// Allocates memory that the system hands out as zeros. Pages of it that are never touched cost
/// nothing.
template <class T>
struct ZeroedAllocator {
  using value_type = T;
  ZeroedAllocator() = default;
  /// Containers convert their allocator to one of other elements, which has to be implicit.
  template <class U>
  ZeroedAllocator(const ZeroedAllocator<U>&) {}  // NOLINT(google-explicit-constructor)

  T* allocate(std::size_t count) {
    if (void* memory = std::calloc(count, sizeof(T))) return static_cast<T*>(memory);
    throw std::bad_alloc();
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  /// Elements without a value keep the zeros of fresh memory.
  void construct(T*) {}
  template <class U>
  void construct(U* at, const U& value) {
    ::new (static_cast<void*>(at)) U(value);
  }
  bool operator==(const ZeroedAllocator&) const { return true; }
};

/// A vector for large arrays of which most elements stay zero: made with its final size, it is
/// filled with zeros at no cost.
template <class T>
using ZeroedVector = std::vector<T, ZeroedAllocator<T>>;

}  // namespace quadrille
