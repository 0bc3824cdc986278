#pragma once
#include <cfloat>
#include <limits>

// What the proofs of docs/theory/decisions.md assume. All of lib/geometry includes this.

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "gapcheck decides exactly: -ffast-math and its relatives break the proofs of its error bounds; remove them"
#endif

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "doubles must be those of IEEE 754");
static_assert(FLT_EVAL_METHOD == 0,
              "doubles must be rounded as doubles: the x87 registers (-m32, -mfpmath=387) round twice");
static_assert(FLT_RADIX == 2);
