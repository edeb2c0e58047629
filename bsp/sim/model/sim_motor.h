/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * An ultrasonic motor with its gear, as a source of speed in encoder ticks. It holds by friction
 * when it is off, does not turn below a tenth of its full speed, starts slowly and stops fast.
 */
#ifndef BORESIGHT_SIM_MOTOR_H
#define BORESIGHT_SIM_MOTOR_H

#include "card/card_frame.h"
#include "robot/robot.h"

#include <stdbool.h>

#define SIM_STEP_US 100U         /**< The one step of all simulated physics. */
#define SIM_MOTOR_RISE_US 15000U /**< Time constant of gaining speed. */
#define SIM_MOTOR_FALL_US 1500U  /**< Time constant of losing speed while driven. */
#define SIM_MOTOR_SLOWEST 0.1    /**< Share of full speed below which friction wins. */
#define SIM_MOTOR_ASYMMETRY 0.03 /**< Largest difference of the two directions from full speed. */
#define SIM_MOTOR_AIR_C 22.0     /**< Temperature of the room. */

typedef enum {
    SIM_MOTOR_NORMAL = 0,
    SIM_MOTOR_STUCK = 1, /**< The shaft cannot turn. */
    SIM_MOTOR_HALF = 2,  /**< Half as fast as the robot's table says. */
    SIM_MOTOR_TWICE = 3, /**< Twice as fast. */
    SIM_MOTOR_RUNS = 4,  /**< A driver's transistor is shorted: upwards at half of full speed while
                            there is a supply, whatever the card says. */
    SIM_MOTOR_HOT = 5    /**< It is as hot as no motor may be. */
} sim_motor_fault_t;

/** Warming of a motor, and its effects. */
typedef struct {
    double settled_c;     /**< Driven for long, it is so much warmer than the air. */
    double warming_share; /**< Part of the rest to that, in a step. */
    double speed_loss;    /**< Share of its speed, for each kelvin above that of its table. */
    double torque_loss;   /**< Share of its torque, the same. */
    double resonance_khz; /**< So much lower is its resonance then. */
} sim_heat_t;

/** State and constants of one motor; fields may be set by the box's fault orders. */
typedef struct {
    double full_speed_ticks_per_s;
    double asymmetry;    /**< Speed is (1 + asymmetry) times nominal upwards, (1 - asymmetry)
                            downwards. */
    double rise_share;   /**< Part of the missing speed that it gains in a step. */
    double minimum_duty; /**< Duty that turns the motor at SIM_MOTOR_SLOWEST of full speed. */
    double maximum_duty; /**< Duty of full speed; 0: run or stop. */
    bool has_waves;      /**< Driven by a high-frequency card: both are words of frequency. */
    double scale;        /**< With waves: its speed, in the published one's at the same word. */
    double amplitude;    /**< With waves: that of full speed. */
    sim_heat_t heat;
    double temperature_c; /**< As its card has it. */
    double lowest_ticks;  /**< Hard stops. */
    double highest_ticks;
    double load; /**< Share 0..1 of the greatest torque that the load takes, in both directions. */
    bool is_inverted; /**< Direction bit 1 makes the position smaller. */
    sim_motor_fault_t fault;
    double position_ticks; /**< True position. */
    double speed_ticks_per_s;
} sim_motor_t;

/** A motor at rest at `position_ticks`; `asymmetry` within +-SIM_MOTOR_ASYMMETRY. */
void sim_motor_init(sim_motor_t *self, const axis_config_t *axis, double position_ticks,
                    double asymmetry);

/**
 * Signed speed that `drive` settles to, ticks/s; 0 when off, in the dead zone or overloaded.
 * From the dead zone's edge (SIM_MOTOR_SLOWEST) to `maximum_duty` it is linear in the duty. By
 * waves it is that of the published sweep, each direction its own, scaled so that both together
 * make full speed at `maximum_duty`, and by amplitude; nothing turns above 54.369 kHz nor below
 * resonance. Warmer than LIMIT_MOTOR_TABLE_DC it is slower and weaker.
 *
 * @satisfies SWR-BOX-009
 * @satisfies SWR-DRIVE-009
 * @satisfies SWR-BOX-011
 */
double sim_motor_steady_speed(const sim_motor_t *self, const card_drive_t *drive);

/** Turns it from outside, by `ticks`, at most to a hard stop. */
void sim_motor_push(sim_motor_t *self, double ticks);

/**
 * Heat figures of the motor of `axis`.
 *
 * @satisfies SWR-BOX-010
 */
sim_heat_t sim_motor_heat(const axis_config_t *axis);

/**
 * Advances by SIM_STEP_US. Without `is_powered`, or with the drive off, it stops within the step
 * and holds.
 *
 * @satisfies SWR-BOX-002
 */
void sim_motor_step(sim_motor_t *self, const card_drive_t *drive, bool is_powered);

#endif
