/* SPDX-License-Identifier: Apache-2.0 */
/* Division by the reciprocal, of every numerator and divisor, for Frama-C's WP. What it relies on
 * is shown elsewhere: the reciprocal by prove_reciprocal.c, lift() and magnitude() by prove_bits.c.
 * What the solver does not find of a loop or a value stands as annotations in proofs.yml. */
#include "base/fixed.h"

#include "base/contract.h"

#include <stdbool.h>
#include <stdint.h>

/* clang-format off */
#define TWO_32 4294967296
#define TWO_63 9223372036854775808
/* Each shift with its power of two. */
#define EVERY(X) \
    X(0, 0x1) X(1, 0x2) X(2, 0x4) X(3, 0x8) X(4, 0x10) X(5, 0x20) X(6, 0x40) X(7, 0x80) \
    X(8, 0x100) X(9, 0x200) X(10, 0x400) X(11, 0x800) X(12, 0x1000) X(13, 0x2000) X(14, 0x4000) \
    X(15, 0x8000) X(16, 0x10000) X(17, 0x20000) X(18, 0x40000) X(19, 0x80000) X(20, 0x100000) \
    X(21, 0x200000) X(22, 0x400000) X(23, 0x800000) X(24, 0x1000000) X(25, 0x2000000) \
    X(26, 0x4000000) X(27, 0x8000000) X(28, 0x10000000) X(29, 0x20000000) X(30, 0x40000000) \
    X(31, 0x80000000)
#define LIFTED(bits, power) && (n == bits ==> wide == whole * power)
#define INVERSE(bits, power) && (n == bits ==> product * power <= TWO_63)
#define POWER(bits, power) n == bits ? power :
#define SAME(bits, power) && same(factor, wide, whole * power)

/*@ predicate is_lifted(integer wide, integer whole, integer n) = 0 <= n <= 31 EVERY(LIFTED);
    predicate is_inverse(integer product, integer n) = 0 <= n <= 31 EVERY(INVERSE);
    predicate is_lift(integer before, integer after, integer result, integer bits, integer least, integer power) =
      before < least ? result == bits && after == before * power : result == 0 && after == before;
    logic integer two_to(integer n) = EVERY(POWER) TWO_32;
    axiomatic Shift {
      // The meaning of C's shifts of what is not negative.
      axiom right: \forall integer x, n; 0 <= x && 0 <= n <= 32 ==>
        0 <= (x >> n) && (x >> n) * two_to(n) <= x < ((x >> n) + 1) * two_to(n);
      axiom low: \forall integer x; 0 <= x ==> (x & 0xFFFFFFFF) == x - (x >> 32) * TWO_32;
      axiom left: \forall integer x, n; 0 <= x && 0 <= n <= 32 ==> (x << n) == x * two_to(n);
    }
*/

/*@ requires \false;
    assigns \nothing;
*/
void contract_broken(const char *module, uint32_t id);

/*@ requires \valid(value);
    assigns *value;
    ensures bits == 1 ==> is_lift(\old(*value), *value, \result, 1, TWO_63, 2);
    ensures bits == 2 ==> is_lift(\old(*value), *value, \result, 2, 0x4000000000000000, 4);
    ensures bits == 4 ==> is_lift(\old(*value), *value, \result, 4, 0x1000000000000000, 16);
    ensures bits == 8 ==> is_lift(\old(*value), *value, \result, 8, 0x100000000000000, 256);
    ensures bits == 16 ==> is_lift(\old(*value), *value, \result, 16, 0x1000000000000, 65536);
*/
static inline uint32_t lift(uint64_t *value, uint32_t bits);

/* Shown by prove_reciprocal.c. */
/*@ requires 0x80000000 <= value_q32;
    assigns \nothing;
    ensures \result * value_q32 <= TWO_63;
*/
static uint32_t reciprocal_q31(uint32_t value_q32);

/*@ requires a <= UINT32_MAX && b <= UINT32_MAX;
    assigns \nothing;
    ensures \result == (a * b) / TWO_32;
*/
static uint64_t multiply_q32(uint64_t a, uint64_t b);

/*@ requires 0 < divisor;
    assigns \nothing;
    ensures SWR_PROOF_800: \result * divisor <= numerator < (\result + 1) * divisor;
*/
uint64_t fixed_divide(uint64_t numerator, uint64_t divisor);

/*@ axiomatic Products {
      lemma scaled: \forall integer a, b, c; 0 <= a <= b && 0 <= c ==> a * c <= b * c;
      lemma cancelled: \forall integer a, b, c; 0 < c && a * c <= b * c ==> a <= b;
    }
    axiomatic Named {
      // Names for what the lemmas above and the equality of products say, by which the solver finds the products that need it.
      predicate scales(integer a, integer b, integer c);
      axiom scales_all: \forall integer a, b, c; scales(a, b, c);
      axiom scales_so: \forall integer a, b, c; scales(a, b, c) ==> (0 <= a <= b && 0 <= c ==> a * c <= b * c);
      predicate same(integer factor, integer a, integer b);
      axiom same_named: \forall integer c, a, b; same(c, a, b);
      axiom same_so: \forall integer c, a, b; same(c, a, b) ==> (a == b ==> c * a == c * b);
      predicate cancels(integer a, integer b, integer c);
      axiom cancels_all: \forall integer a, b, c; cancels(a, b, c);
      axiom cancels_so: \forall integer a, b, c; cancels(a, b, c) ==> (0 < c && a * c <= b * c ==> a <= b);
    }
*/
/*@ predicate same_all(integer factor, integer wide, integer whole) = \true EVERY(SAME);
*/
/*@ ghost
  /@ requires is_lifted(value, divisor, shift) && reciprocal * value <= TWO_63;
     assigns \nothing;
     ensures is_inverse(reciprocal * divisor, shift);
  @/
  void lemma_inverse(uint64_t reciprocal, uint64_t value, uint64_t divisor, uint32_t shift)
  {
    /@ assert same_all(reciprocal, value, divisor); @/
  }
*/
/*@ ghost
  /@ requires part * shifted <= upper * reciprocal + (lower * reciprocal) / TWO_32;
     requires reciprocal * divisor <= TWO_32 * shifted && 0 < shifted;
     assigns \nothing;
     ensures part * divisor <= upper * TWO_32 + lower;
  @/
  void lemma_part(uint64_t part, uint64_t shifted, uint64_t upper, uint64_t lower, uint64_t reciprocal, uint64_t divisor)
  {
    /@ assert one: part * shifted * TWO_32 <= (upper * TWO_32 + lower) * reciprocal; @/
    /@ assert two: scales(part * shifted * TWO_32, (upper * TWO_32 + lower) * reciprocal, divisor); @/
    /@ assert three: scales(reciprocal * divisor, TWO_32 * shifted, upper * TWO_32 + lower); @/
    /@ assert four: cancels(part * divisor, upper * TWO_32 + lower, TWO_32 * shifted); @/
  }
*/

/*@ assigns \nothing;
    ensures \result == \abs(value);
*/
static uint64_t magnitude(int64_t value);

/*@ requires is_negative ? size <= TWO_63 : size < TWO_63;
    assigns \nothing;
    ensures \result == (is_negative ? -size : size);
*/
static int64_t with_sign(uint64_t size, bool is_negative);

/*@ requires 0 < denominator;
    assigns \nothing;
    ensures SWR_PROOF_800: 0 <= numerator ==> -denominator < 2 * (\result * denominator - numerator);
    ensures SWR_PROOF_800: 0 <= numerator ==> 2 * (\result * denominator - numerator) <= denominator;
    ensures SWR_PROOF_800: numerator < 0 ==> -denominator <= 2 * (\result * denominator - numerator);
    ensures SWR_PROOF_800: numerator < 0 ==> 2 * (\result * denominator - numerator) < denominator;
*/
int64_t fixed_divide_rounded(int64_t numerator, int64_t denominator);

/*@ requires 0 < divisor;
    assigns \nothing;
    ensures SWR_PROOF_800: 0 <= value ==> \result * divisor <= value < (\result + 1) * divisor;
    ensures SWR_PROOF_800: value < 0 ==> (\result - 1) * divisor < value <= \result * divisor;
*/
int64_t fixed_divide_signed(int64_t value, int64_t divisor);

static uint64_t numerator;
static uint64_t divisor;
static int64_t value;
static int64_t denominator;

/*@ requires 0 < divisor && 0 < denominator;
    assigns \nothing;
*/
void prove_SWR_PROOF_800_quotients_are_exact_or_the_nearest(void)
{
    const uint64_t quotient = fixed_divide(numerator, divisor);
    /*@ check SWR_PROOF_800: quotient * divisor <= numerator < (quotient + 1) * divisor; */
    const int64_t nearest = fixed_divide_rounded(value, denominator);
    /*@ check SWR_PROOF_800: -denominator <= 2 * (nearest * denominator - value) <= denominator; */
    const int64_t part = fixed_divide_signed(value, denominator);
    /*@ check SWR_PROOF_800: -denominator < part * denominator - value < denominator; */
    (void)quotient;
    (void)nearest;
    (void)part;
}
/* clang-format on */

#include "base/fixed.c"
