/* SPDX-License-Identifier: Apache-2.0 */
/* Set-points on the cubic between two points in time, of any control points and every share of the
 * time. Each function is proved against its contract, for Frama-C's WP; that of the shift is proved
 * in base/prove_fixed.c. */
#include "motion/cubic.h"

#include "base/fixed.h"

#include <stdint.h>

/* 2^40: 2^32 ticks with 8 fraction bits. */
#define WIDEST INT64_C(1099511627776)

/* clang-format off */
/*@ axiomatic Shares {
      lemma share: \forall integer way, share; 0 <= share <= 1048576 ==>
        (0 <= way ==> 0 <= way * share <= way * 1048576)
        && (way <= 0 ==> way * 1048576 <= way * share <= 0);
    }
    axiomatic Scaled {
      // A name for what the lemma above shows, by which the solver finds the products that need it.
      predicate is_scaled(integer way, integer share);
      axiom scaled: \forall integer way, share; 0 <= share <= 1048576 ==> is_scaled(way, share);
      axiom meaning: \forall integer way, share; is_scaled(way, share) ==>
        (0 <= way ==> 0 <= way * share <= way * 1048576)
        && (way <= 0 ==> way * 1048576 <= way * share <= 0);
    }
    axiomatic Ends {
      // Any two: what holds for them holds for the smallest and the largest control point.
      logic integer low;
      logic integer high;
      lemma truncated: \forall integer product;
        product <= 0 ==> product <= 1048576 * (product / 1048576) <= 0;
    }
    logic integer rounded(integer q8) = q8 < 0 ? -((128 - q8) / 256) : (q8 + 128) / 256;
    predicate is_within(integer q8) = -WIDEST <= q8 <= WIDEST && low <= rounded(q8) <= high;
    predicate are_within(cubic_t *c) =
      is_within(c->at_q8[0]) && is_within(c->at_q8[1]) && is_within(c->at_q8[2]) && is_within(c->at_q8[3]);
*/

/*@ requires -WIDEST <= value <= WIDEST && bits == 8;
    assigns \nothing;
    ensures \result == rounded(value);
*/
static inline int64_t fixed_shift_rounded(int64_t value, uint32_t bits);

/*@ assigns \nothing;
    ensures -2147483648 <= value <= 2147483647 ==> \result == value;
*/
static inline int32_t fixed_saturate(int64_t value);

/*@ requires -WIDEST <= a <= WIDEST && -WIDEST <= b <= WIDEST && share_q20 <= CUBIC_ONE_Q20;
    requires is_scaled(b - a, share_q20);
    assigns \nothing;
    ensures SWR_TRAJ_510: a <= b ==> a <= \result <= b;
    ensures SWR_TRAJ_510: b <= a ==> b <= \result <= a;
*/
static int64_t between(int64_t a, int64_t b, uint32_t share_q20);

/*@ requires \valid_read(self) && \valid(last_q8 + (0 .. 1));
    requires \separated(self, last_q8 + (0 .. 1));
    requires share_q20 <= CUBIC_ONE_Q20 && are_within(self);
    assigns last_q8[0 .. 1];
    ensures SWR_TRAJ_510: is_within(last_q8[0]) && is_within(last_q8[1]);
*/
static void narrow(const cubic_t *self, uint32_t share_q20, int64_t last_q8[2]);

/*@ requires \valid_read(self) && share_q20 <= CUBIC_ONE_Q20 && are_within(self);
    requires -2147483648 <= low && high <= 2147483647;
    assigns \nothing;
    ensures SWR_TRAJ_510: low <= \result <= high;
*/
int32_t cubic_position_ticks(const cubic_t *self, uint32_t share_q20);

static cubic_t cubic;
static uint32_t share_q20;

/*@ requires share_q20 <= CUBIC_ONE_Q20 && are_within(&cubic);
    requires -2147483648 <= low && high <= 2147483647;
    assigns \nothing;
*/
void prove_SWR_TRAJ_510_a_set_point_lies_among_the_control_points(void)
{
    const int32_t position = cubic_position_ticks(&cubic, share_q20);
    /*@ check SWR_TRAJ_510: low <= position <= high; */
    (void)position;
}
/* clang-format on */

#include "motion/cubic.c"
