#pragma once

// Marks a function whose loops are worth compiling twice, for AVX2 and for any x86-64; the loader
// picks the version that the machine can run. Both perform the same operations (no fused
// multiply-add), so the results are the same bits.
// Sanitizers are not set up yet when the loader picks, so they get one version. Clang 14 names the
// resolver such that other sources do not find it, so clang gets one version too.
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

// Marks a helper that a function with QUADRILLE_VECTOR_CLONES calls in its loop. It has to be
// inlined there: compiled on its own it would not get AVX2 instructions, and neither would a
// template, since compilers clone no templates.
#define QUADRILLE_INTO_CLONES inline __attribute__((always_inline))
