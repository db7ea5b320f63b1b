#pragma once

// Marks a function with loops worth compiling twice, for AVX2 and for any x86-64; the loader picks
// the one that the machine can run. The arithmetic is the same operation by operation (no fused
// multiply-add), so that the results are the same bits.
// Sanitizers are not yet set up when the loader picks. Clang 14 names what the loader picks so that
// no other source finds it; what clang compiles goes without.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define QUADRILLE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define QUADRILLE_SANITIZED 1
#endif
#endif

#if defined(__x86_64__) && defined(__ELF__) && !defined(__clang__) && !defined(QUADRILLE_SANITIZED)
#define QUADRILLE_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define QUADRILLE_VECTOR_CLONES
#endif
