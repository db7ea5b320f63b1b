#pragma once

#include <Eigen/Core>
#include <cstddef>

/// @file
/// Checks that a program uses Eigen as quadrille's libraries do. Eigen's macros, and flags such as
/// -march=native that set them, change the layout of members in public structs, the allocation of
/// matrices, and Eigen's inline functions, which assume both and of which the linker keeps one
/// version for the whole program. A program that would differ from the libraries does not compile.
/// Each public header that names a type of Eigen includes this one.

static_assert(
    EIGEN_MAX_ALIGN_BYTES == 16 && alignof(Eigen::Matrix4d) == 16 &&
        EIGEN_MALLOC_ALREADY_ALIGNED == 1,
    "Eigen aligns or allocates matrices here otherwise than in quadrille's libraries, as "
    "-march=native makes it do; define EIGEN_MAX_ALIGN_BYTES=16 and EIGEN_MALLOC_ALREADY_ALIGNED=1 "
    "for the WHOLE program, in CMake by "
    "add_compile_definitions(EIGEN_MAX_ALIGN_BYTES=16 EIGEN_MALLOC_ALREADY_ALIGNED=1) at its top");
static_assert(!Eigen::Matrix4d::IsRowMajor,
              "quadrille's matrices are stored by columns: leave out EIGEN_DEFAULT_TO_ROW_MAJOR");
static_assert(
    sizeof(Eigen::Index) == sizeof(std::ptrdiff_t),
    "quadrille's matrices have Eigen's own index: leave out EIGEN_DEFAULT_DENSE_INDEX_TYPE");
