/* SPDX-License-Identifier: Apache-2.0 */
/* The profile that axes share, of every way, speed and acceleration that the robot compiler
 * accepts, in any cycle and the next, for Frama-C's WP. The cycles are any that are long enough for
 * way, speed and acceleration of the axis; that profile_plan() makes them so is shown by its tests.
 * The lemma functions show what the solver does not find on its own: products of several unknown
 * numbers. */
#include "motion/profile.h"

#include "base/contract.h"
#include "base/fixed.h"
#include "limits/requirement_limits.h"

#include <stdint.h>
#include <string.h>

/* The robot compiler accepts 2 million ticks; the rest is for an axis that is beyond its limit. */
#define WIDEST_WAY INT64_C(2097152)
/* R + C: the longest travel at one percent of the speed takes 4.1e8 cycles. */
#define LARGEST_PLATEAU INT64_C(536870912)
/* R (R + C): at the least acceleration it is half of that at most. */
#define LARGEST_PRODUCT INT64_C(1099511627776)
#define LARGEST_RAMP INT64_C(1048576)
#define LARGEST_NUMERATOR INT64_C(4611686018427387904)
#define LARGEST_SPEED INT64_C(1000000000)
/* In 1/10000 ticks/s: the fastest axis at all of the speed that a profile may have. */
#define LARGEST_SPEED_E4                                                                           \
    (INT64_C(100) * LIMIT_PROFILE_SPEED_PERCENT * LIMIT_AXIS_SPEED_MOST_TICKS_PER_S)
#define Q8_PER_S INT64_C(256000)

/* clang-format off */
/*@ axiomatic Nearest {
      // The nearest whole number, of two the one further away from zero: fixed_divide_rounded().
      logic integer nearest(integer numerator, integer denominator);
      axiom half: \forall integer n, d; 0 < d ==> -d <= 2 * (nearest(n, d) * d - n) <= d;
      axiom mirrored: \forall integer n, m, d; 0 < d && m == -n ==> nearest(m, d) == -nearest(n, d);
    }
    logic integer plateau(profile_t *p) = p->ramp_cycles + p->cruise_cycles;
    logic integer total(profile_t *p) = p->ramp_cycles + plateau(p);
    logic integer left(profile_t *p) = total(p) - p->cycle;
    logic integer share(profile_t *p) = \min(p->ramp_cycles, \min(p->cycle, left(p)));
    logic integer way(profile_t *p, integer axis) = p->end_ticks[axis] - p->start_ticks[axis];
    predicate is_planned(profile_t *p) =
      1 <= p->ramp_cycles && p->ramp_cycles * plateau(p) <= LARGEST_PRODUCT
      && plateau(p) <= LARGEST_PLATEAU && p->cycle <= total(p);
    predicate is_on_way(integer position, integer length) =
      0 <= length ? 0 <= position <= length : length <= position <= 0;
    predicate fits(integer numerator) = -LARGEST_NUMERATOR <= numerator <= LARGEST_NUMERATOR;
    // What the lemma functions show of products, also in the form of the code, and of quotients.
    predicate is_on_ramp(integer length, integer k, integer ramp, integer top) =
      fits(length * k) && fits(length * k * k) && fits((int64_t)(length * k) * k)
      && 0 < 2 * ramp * top <= LARGEST_NUMERATOR && 0 < (int64_t)(2 * ramp) * top <= LARGEST_NUMERATOR
      && is_on_way(nearest(length * k * k, 2 * ramp * top), length);
    predicate is_on_cruise(integer length, integer k, integer ramp, integer top) =
      fits(length * (2 * k - ramp)) && fits(length * (int64_t)((int64_t)(2 * k) - ramp))
      && is_on_way(nearest(length * (2 * k - ramp), 2 * top), length);
    axiomatic Speeds {
      // Definitions under a name that the solver keeps: it has to know two of them for the same.
      logic integer speed_of(integer length, integer share, integer ramp, integer top);
      axiom speed: \forall integer length, share, ramp, top;
        speed_of(length, share, ramp, top) == nearest(length * share * Q8_PER_S, ramp * top);
      predicate is_speed(integer length, integer share, integer ramp, integer top);
      axiom meaning: \forall integer length, share, ramp, top; is_speed(length, share, ramp, top) <==>
        fits(length * share) && fits((int64_t)(length * share) * 256)
        && fits(length * share * Q8_PER_S)
        && (int64_t)((int64_t)(length * share) * 256) * 1000 == length * share * Q8_PER_S
        && 0 < ramp * top <= LARGEST_NUMERATOR
        && -LARGEST_SPEED <= speed_of(length, share, ramp, top) <= LARGEST_SPEED;
    }
*/

/*@ requires \false;
    assigns \nothing;
*/
void contract_broken(const char *module, uint32_t id);

/*@ requires 0 < denominator && fits(numerator);
    assigns \nothing;
    ensures \result == nearest(numerator, denominator);
*/
int64_t fixed_divide_rounded(int64_t numerator, int64_t denominator);

/*@ assigns \nothing;
    ensures -2147483648 <= value <= 2147483647 ==> \result == value;
*/
static inline int32_t fixed_saturate(int64_t value);

/*@ requires -9223372036854775807 <= value;
    assigns \nothing;
    ensures \result == \abs(value);
*/
static inline int64_t fixed_magnitude(int64_t value);

/*@ assigns \nothing;
    ensures \result == \min(a, b);
*/
static int64_t smaller(int64_t a, int64_t b);

/*@ requires \valid_read(self) && total(self) <= UINT32_MAX;
    assigns \nothing;
    ensures \result == total(self);
*/
static int64_t total_cycles(const profile_t *self);

/*@ requires \valid_read(self) && total(self) <= UINT32_MAX;
    assigns \nothing;
    ensures \result <==> total(self) <= self->cycle;
*/
bool profile_is_finished(const profile_t *self);

/*@ requires \valid(self) && is_planned(self);
    assigns self->cycle;
    ensures self->cycle == \min(\old(self->cycle) + 1, total(self));
    ensures SWR_PROFILE_800: is_planned(self);
    ensures plateau(self) == \old(plateau(self)) && total(self) == \old(total(self));
*/
void profile_step(profile_t *self);

/*@ requires \valid_read(self) && is_planned(self) && axis < ROBOT_AXIS_MAX;
    requires self->cycle < self->ramp_cycles ==>
      is_on_ramp(way(self, axis), self->cycle, self->ramp_cycles, plateau(self));
    requires left(self) < self->ramp_cycles ==>
      is_on_ramp(way(self, axis), left(self), self->ramp_cycles, plateau(self));
    requires self->ramp_cycles <= self->cycle && self->ramp_cycles <= left(self) ==>
      is_on_cruise(way(self, axis), self->cycle, self->ramp_cycles, plateau(self));
    assigns \nothing;
    ensures SWR_PROFILE_800: is_on_way(\result - self->start_ticks[axis], way(self, axis));
    ensures SWR_PROFILE_800: left(self) == 0 ==> \result == self->end_ticks[axis];
*/
int32_t profile_position_ticks(const profile_t *self, uint32_t axis);

/*@ requires \valid_read(self) && is_planned(self) && axis < ROBOT_AXIS_MAX;
    requires is_speed(way(self, axis), share(self), self->ramp_cycles, plateau(self));
    assigns \nothing;
    ensures SWR_PROFILE_800: \result == (left(self) == 0 ? 0 :
      speed_of(way(self, axis), share(self), self->ramp_cycles, plateau(self)));
*/
int32_t profile_speed_ticks_per_s_q8(const profile_t *self, uint32_t axis);

/*@ requires 0 <= a <= b && 0 <= c;
    assigns \nothing;
    ensures 0 <= a * c <= b * c;
*/
static void lemma_scaled(int64_t a, int64_t b, int64_t c)
{
    /*@ assert 0 < c && a < b ==> c <= (b - a) * c; */
    /*@ assert 0 < c && 0 < a ==> c <= a * c; */
}

/*@ requires 0 < c && a * c <= b * c;
    assigns \nothing;
    ensures a <= b;
*/
static void lemma_cancelled(int64_t a, int64_t b, int64_t c)
{
    /*@ assert b < a ==> c <= (a - b) * c; */
}

/*@ requires 0 <= ramp && ramp * ramp <= LARGEST_PRODUCT;
    assigns \nothing;
    ensures ramp <= LARGEST_RAMP;
*/
static void lemma_squared(int64_t ramp)
{
    /*@ assert LARGEST_RAMP < ramp ==> LARGEST_RAMP * ramp < ramp * ramp; */
}

/*@ requires -WIDEST_WAY <= way <= WIDEST_WAY;
    requires 0 <= k <= ramp <= top && 1 <= ramp && ramp * top <= LARGEST_PRODUCT;
    assigns \nothing;
    ensures is_on_ramp(way, k, ramp, top);
*/
static void lemma_ramp(int64_t way, int64_t k, int64_t ramp, int64_t top)
{
    const int64_t length = fixed_magnitude(way);
    lemma_scaled(k, ramp, length);
    lemma_scaled(length, WIDEST_WAY, ramp);
    /*@ assert (int64_t)(way * k) == way * k; */
    lemma_scaled(k, ramp, k);
    lemma_scaled(k, top, ramp);
    lemma_scaled(k * k, ramp * top, length);
    lemma_scaled(length, WIDEST_WAY, ramp * top);
    lemma_scaled(1, top, ramp);
    lemma_scaled(1, ramp, top);
    /*@ assert (int64_t)(way * k) * k == way * k * k; */
    const int64_t place = fixed_divide_rounded(length * k * k, 2 * ramp * top);
    /*@ assert -1 < place; */
    lemma_cancelled(2 * place, length + 1, ramp * top);
    /*@ assert 0 <= place <= length; */
    /*@ assert nearest(way * k * k, 2 * ramp * top) == (way < 0 ? -place : place); */
    /*@ assert is_on_way(nearest(way * k * k, 2 * ramp * top), way); */
    /*@ assert fits(way * k) && fits(way * k * k) && fits((int64_t)(way * k) * k); */
    /*@ assert (int64_t)(2 * ramp) * top == 2 * ramp * top; */
    /*@ assert 0 < 2 * ramp * top <= LARGEST_NUMERATOR; */
}

/*@ requires -WIDEST_WAY <= way <= WIDEST_WAY;
    requires 1 <= ramp <= k <= top && top <= LARGEST_PLATEAU;
    assigns \nothing;
    ensures is_on_cruise(way, k, ramp, top);
*/
static void lemma_cruise(int64_t way, int64_t k, int64_t ramp, int64_t top)
{
    const int64_t length = fixed_magnitude(way);
    const int64_t part = 2 * k - ramp;
    lemma_scaled(part, 2 * top, length);
    lemma_scaled(length, WIDEST_WAY, top);
    const int64_t place = fixed_divide_rounded(length * part, 2 * top);
    /*@ assert -1 < place; */
    lemma_cancelled(2 * place, 2 * length + 1, top);
    /*@ assert 0 <= place <= length; */
    /*@ assert nearest(way * part, 2 * top) == (way < 0 ? -place : place); */
    /*@ assert is_on_way(nearest(way * part, 2 * top), way); */
}

/*@ requires -WIDEST_WAY <= way <= WIDEST_WAY;
    requires 0 <= part <= ramp <= top <= LARGEST_PLATEAU && 1 <= ramp && ramp * top <= LARGEST_PRODUCT;
    requires \abs(way) * 10000000 <= top * speed && 0 <= speed <= LARGEST_SPEED_E4;
    assigns \nothing;
    ensures is_speed(way, part, ramp, top);
    ensures part == 0 ==> speed_of(way, part, ramp, top) == 0;
    ensures 20000 * \abs(speed_of(way, part, ramp, top)) <= 512 * speed + 10000;
*/
static void lemma_speed(int64_t way, int64_t part, int64_t ramp, int64_t top, int64_t speed)
{
    const int64_t length = fixed_magnitude(way);
    lemma_scaled(part, ramp, length);
    lemma_scaled(length, WIDEST_WAY, ramp);
    lemma_scaled(1, top, ramp);
    lemma_scaled(1, ramp, top);
    lemma_scaled(ramp, top, ramp);
    lemma_squared(ramp);
    /*@ assert (int64_t)(way * part) == way * part; */
    /*@ assert (int64_t)(way * part * 256) == way * part * 256; */
    const int64_t speed_q8 = fixed_magnitude(fixed_divide_rounded(Q8_PER_S * (way * part), ramp * top));
    /*@ assert (2 * speed_q8 - 1) * (ramp * top) <= 2 * (Q8_PER_S * (length * part)); */
    if (0 < speed_q8) {
        lemma_scaled(1, speed_q8, ramp * top);
        lemma_scaled(ramp, ramp * top, speed_q8);
        lemma_cancelled(speed_q8, 2 * Q8_PER_S * length, ramp);
    }
    /*@ assert part == 0 ==> speed_q8 == 0; */
    lemma_scaled(length * 10000000, top * speed, ramp);
    lemma_cancelled(20000 * speed_q8, 512 * speed + 10000, ramp * top);
}

/*@ requires -1 <= next - part <= 1;
    assigns \nothing;
    ensures -\abs(way) <= way * next - way * part <= \abs(way);
*/
static void lemma_neighbour(int64_t way, int64_t part, int64_t next)
{
    /*@ assert part < next ==> next == part + 1 && way * next == way * part + way; */
    /*@ assert next < part ==> next == part - 1 && way * next == way * part - way; */
}

/*@ requires -WIDEST_WAY <= way <= WIDEST_WAY && -1 <= next - part <= 1;
    requires 0 <= part <= ramp && 0 <= next <= ramp <= top && 1 <= ramp && ramp * top <= LARGEST_PRODUCT;
    requires \abs(way) * 1000000 <= ramp * top * acceleration;
    requires 0 <= acceleration <= LIMIT_ACCELERATION_MOST_TICKS_PER_S2;
    requires is_speed(way, part, ramp, top) && is_speed(way, next, ramp, top);
    assigns \nothing;
    ensures 1000 * (\abs(speed_of(way, next, ramp, top) - speed_of(way, part, ramp, top)) - 1)
            <= 256 * acceleration;
*/
static void lemma_change(int64_t way, int64_t part, int64_t next, int64_t ramp, int64_t top, int64_t acceleration)
{
    const int64_t length = fixed_magnitude(way);
    const int64_t area = ramp * top;
    const int64_t before = fixed_divide_rounded(Q8_PER_S * (way * part), area);
    const int64_t after = fixed_divide_rounded(Q8_PER_S * (way * next), area);
    lemma_neighbour(way, part, next);
    /*@ assert (after - before - 1) * area <= Q8_PER_S * length; */
    /*@ assert (before - after - 1) * area <= Q8_PER_S * length; */
    lemma_cancelled(1000 * (after - before - 1), 256 * acceleration, area);
    lemma_cancelled(1000 * (before - after - 1), 256 * acceleration, area);
}

static profile_t profile;
static uint32_t axis;
static int32_t acceleration;
static int64_t speed_e4;

/* The speed in this cycle and the next. */
/*@ requires is_planned(&profile) && axis < ROBOT_AXIS_MAX;
    requires -WIDEST_WAY <= way(&profile, axis) <= WIDEST_WAY && 0 <= speed_e4 <= LARGEST_SPEED_E4;
    requires 0 <= acceleration <= LIMIT_ACCELERATION_MOST_TICKS_PER_S2;
    requires \abs(way(&profile, axis)) * 10000000 <= plateau(&profile) * speed_e4;
    requires \abs(way(&profile, axis)) * 1000000 <=
             profile.ramp_cycles * plateau(&profile) * acceleration;
    assigns profile.cycle;
*/
static void lemma_two_cycles(void)
{
    const int64_t path = (int64_t)profile.end_ticks[axis] - (int64_t)profile.start_ticks[axis];
    const int64_t ramp = (int64_t)profile.ramp_cycles;
    const int64_t top = ramp + (int64_t)profile.cruise_cycles;
    const int64_t left = total_cycles(&profile) - (int64_t)profile.cycle;
    const int64_t part = smaller(ramp, smaller((int64_t)profile.cycle, left));
    lemma_scaled(1, ramp, top);
    lemma_speed(path, part, ramp, top, speed_e4);
    const int32_t speed = profile_speed_ticks_per_s_q8(&profile, axis);
    /*@ assert speed == speed_of(path, part, ramp, top); */
    /*@ check SWR_PROFILE_800: 20000 * \abs(speed) <= 512 * speed_e4 + 10000; */
    profile_step(&profile);
    const int64_t next_left = total_cycles(&profile) - (int64_t)profile.cycle;
    const int64_t next = smaller(ramp, smaller((int64_t)profile.cycle, next_left));
    lemma_speed(path, next, ramp, top, speed_e4);
    lemma_change(path, part, next, ramp, top, acceleration);
    /*@ assert next == share(&profile); */
    /*@ assert top == plateau(&profile) && path == way(&profile, axis) && ramp == profile.ramp_cycles; */
    /*@ assert is_speed(way(&profile, axis), share(&profile), profile.ramp_cycles, plateau(&profile)); */
    const int32_t next_speed = profile_speed_ticks_per_s_q8(&profile, axis);
    /*@ assert next_speed == speed_of(path, next, ramp, top); */
    /*@ check SWR_PROFILE_800: 1000 * (\abs(next_speed - speed) - 1) <= 256 * acceleration; */
    (void)speed;
    (void)next_speed;
}

/*@ requires is_planned(&profile) && axis < ROBOT_AXIS_MAX;
    requires -WIDEST_WAY <= way(&profile, axis) <= WIDEST_WAY && 0 <= speed_e4 <= LARGEST_SPEED_E4;
    requires 0 <= acceleration <= LIMIT_ACCELERATION_MOST_TICKS_PER_S2;
    requires \abs(way(&profile, axis)) * 10000000 <= plateau(&profile) * speed_e4;
    requires \abs(way(&profile, axis)) * 1000000 <=
             profile.ramp_cycles * plateau(&profile) * acceleration;
    assigns profile.cycle;
*/
void prove_SWR_PROFILE_800_set_points_keep_their_limits(void)
{
    const int64_t path = (int64_t)profile.end_ticks[axis] - (int64_t)profile.start_ticks[axis];
    const int64_t ramp = (int64_t)profile.ramp_cycles;
    const int64_t top = ramp + (int64_t)profile.cruise_cycles;
    const int64_t left = total_cycles(&profile) - (int64_t)profile.cycle;
    lemma_scaled(1, ramp, top);
    if ((int64_t)profile.cycle < ramp) {
        lemma_ramp(path, (int64_t)profile.cycle, ramp, top);
    } else if (left < ramp) {
        lemma_ramp(path, left, ramp, top);
    } else {
        lemma_cruise(path, (int64_t)profile.cycle, ramp, top);
    }
    const int32_t position = profile_position_ticks(&profile, axis);
    /*@ check SWR_PROFILE_800: is_on_way(position - profile.start_ticks[axis], way(&profile, axis)); */
    (void)position;
    lemma_two_cycles();
}
/* clang-format on */

#include "motion/profile.c"
