/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The simulated control box: daughter cards with their axes in up to ten slots, a two-channel foot
 * pedal, a button, an emergency stop, a scanner signal, tissue and a hand at the handle, and orders
 * that press, pull and break them. It has no clock of its own: box_advance() is its time. The same
 * seed and the same calls give the same bytes.
 *
 * Direction bit 1 makes a position grow unless the axis' motor is inverted; a reading grows with
 * the position unless its encoder is inverted. Readings start anywhere, that of axis 1 just below
 * the wrap of int32_t.
 */
#ifndef BORESIGHT_BOX_H
#define BORESIGHT_BOX_H

#include "bsp.h"
#include "bsp_bench.h"
#include "card/card_frame.h"
#include "robot/robot.h"
#include "sim/box_force.h"
#include "sim/model/sim_card.h"
#include "sim/model/sim_encoder.h"
#include "sim/model/sim_imager.h"
#include "sim/model/sim_motor.h"
#include "sim/model/sim_switch.h"

#include <stdbool.h>
#include <stdint.h>

#define BOX_PEDAL_CLOSE_SPREAD_US 4000U /**< `press`: channel A follows channel B. */
#define BOX_PEDAL_OPEN_SPREAD_US 2000U  /**< `release`: channel B follows channel A. */
#define BOX_PULSE_US 300U               /**< `pulse`: open for this time. */
#define BOX_HAND_NM_PER_S 5000000U      /**< Speed at which a hand pushes the probe. */
#define BOX_PUSH_MOST_MM 200            /**< The longest push, in or out. */
#define BOX_HAND_CONVERTER 1U        /**< Converter of a card without an axis: force of the hand, */
#define BOX_NEEDLE_CONVERTER 2U      /**< and force on the needle. */
#define BOX_WISH_MOST_UM_PER_S 20000 /**< The fastest wish of a hand, in or out, */
#define BOX_WISH_MOST_UM 200000      /**< and the farthest. */
#define BOX_STIFFNESS_LEAST 100      /**< Stiffness of a hand, mN/mm. */
#define BOX_STIFFNESS_MOST 10000
#define BOX_GRIP_MOST_MN 30000         /**< The strongest press of a hand, in or out. */
#define BOX_CURVATURE_MOST 20000       /**< The most that orders may set: per km, */
#define BOX_TORSION_MOST 90            /**< degrees per 100 mm, */
#define BOX_IMAGE_MOST_MS 60000        /**< period and delay of images */
#define BOX_IMAGE_NOISE_MOST_UM 10000  /**< and their noise */
#define BOX_IMAGE_TILT_MOST_MDEG 10000 /**< in place and direction. */
#define BOX_REPLY_SIZE 8192U           /**< Room for any reply. */

typedef enum {
    BOX_CARD_NORMAL = 0,
    BOX_CARD_SILENT = 1,  /**< Hears nothing and answers nothing. */
    BOX_CARD_CORRUPT = 2, /**< Hears; a byte of each answer is wrong. */
    BOX_CARD_FOREIGN = 3, /**< One with another firmware. */
    BOX_CARD_DEAF = 4,    /**< Hears nothing; answers. */
    BOX_CARD_NOISY = 5,   /**< One command of fifty comes damaged. */
    BOX_CARD_WARM = 6,    /**< Its driver is warm. */
    BOX_CARD_HOT = 7,     /**< Its driver is hotter than it may be. */
    BOX_CARD_LOW = 8,     /**< Its supply is too low. */
    BOX_CARD_HIGH = 9     /**< Its supply is too high. */
} box_card_fault_t;

/** One axis with the card that drives it. */
typedef struct {
    const axis_config_t *config;
    sim_motor_t motor;
    sim_encoder_t encoder;
    sim_switch_t limit_switch;
    sim_card_t card;
    box_card_fault_t card_fault;
} box_axis_t;

/** A card without an axis. */
typedef struct {
    sim_encoder_t encoder; /**< Nothing turns it. */
    sim_card_t card;
    box_card_fault_t card_fault;
} box_sensor_t;

/** The probe, and the hand that pushes it along its line. */
typedef struct {
    bool is_free;       /**< It is not coupled to the needle's axis: that stays where it is. */
    double free_ticks;  /**< Free: way that it was pushed in, in ticks of that axis. */
    double to_go_ticks; /**< Rest of a push, the same; below 0 outwards. */
} box_probe_t;

/** A contact that may have a change under way. */
typedef struct {
    bool is_closed;
    bool will_be_closed;
    uint32_t delay_us; /**< 0: nothing under way. */
} box_contact_t;

/** Inputs that can be held from afar. */
typedef enum { BOX_HELD_PEDAL = 0, BOX_HELD_BUTTON = 1, BOX_HELD_HAND = 2 } box_held_t;
#define BOX_HOLDS 3U

/** Holder of one of them from afar. */
typedef struct {
    uint32_t holder;   /**< 0: none. */
    uint32_t renewals; /**< Grows each time the holder renews it. */
} box_hold_t;

/** State of the gate of the treatment. */
typedef enum { BOX_GATE_OFF = 0, BOX_GATE_DOSE = 1, BOX_GATE_STOP = 2 } box_gate_t;

/** State of the box; owned by the caller, written by this module only. */
typedef struct {
    const robot_t *robot;
    sim_random_t random;
    box_axis_t axes[ROBOT_AXIS_MAX];
    box_sensor_t sensors[CARD_SLOT_COUNT]; /**< By slot; where one is in it. */
    uint32_t sensor_slots;                 /**< Bit n: a card without an axis is in slot n. */
    box_contact_t pedal_a;
    box_contact_t pedal_b;
    box_contact_t estop; /**< Closed: not pulled. */
    box_probe_t probe;
    box_force_t force;
    sim_imager_t imager;
    bool scanner_active;
    bool button_pressed;         /**< The operator's, for confirming positions. */
    box_hold_t holds[BOX_HOLDS]; /**< By box_held_t. */
    box_gate_t gate;             /**< Gate of the treatment. */
    bool is_off;                 /**< The amplifier-off line is set: no drive has power. */
    uint32_t lamps;              /**< BSP_LAMP_ bits that are lit. */
    uint32_t dropped;            /**< BSP_IN_ bits that were 0 in the last sample or since. */
    uint64_t time_us;            /**< Whole steps done. */
    uint32_t pending_us;         /**< Time not yet stepped, below SIM_STEP_US. */
} box_t;

/**
 * Switches on a box with the axes of `robot`, which must outlive it; they stand at start_ticks. A
 * card without an axis answers, and has no motor.
 *
 * @satisfies SWR-LINK-010
 */
void box_init(box_t *self, const robot_t *robot, uint32_t seed);

/**
 * Full-duplex exchange with the slots of `send`. Each card's report is from before it reads its
 * command.
 *
 * @return bit n set: `received[n]` was filled by slot n
 */
uint32_t box_exchange(box_t *self, uint32_t send,
                      const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                      uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES]);

/** Lets `us` pass, in steps of SIM_STEP_US; a rest is kept for the next call. */
void box_advance(box_t *self, uint32_t us);

/** Levels of the digital inputs now: BSP_IN_ bits. */
uint32_t box_inputs(const box_t *self);

/** The same, and the inputs that were 0 at any time since the last call, that included: an opened
 * contact is seen, however short. All are valid; the time is not given. */
bsp_inputs_t box_sample(box_t *self);

/** True positions, in ticks, in axis order; entries beyond the robot's axes are 0. */
void box_true_positions(const box_t *self, double positions_ticks[ROBOT_AXIS_MAX]);

/**
 * Carries out one order, for example "card 3 silent" or "pedal press"; box_orders() lists them. A
 * slot may be given by its number or by its axis' name; a card without an axis takes "card" only.
 *
 * @param reply receives what was done, or the table asked for, or one sentence why it was refused
 * @return false when the order was refused; then nothing has changed
 *
 * @satisfies SWR-BOX-003
 * @satisfies SWR-BOX-024
 */
bool box_command(box_t *self, const char *order, char *reply, uint32_t reply_size);

/** The orders that box_command() knows, one a line. */
const char *box_orders(void);

/** Puts a card of `card_type`, which nothing is connected to, into `slot`, which no axis has;
 * CARD_TYPE_NONE takes out the card that is there. */
void box_plug(box_t *self, uint32_t slot, uint32_t card_type);

/**
 * A hand pushes the probe by `mm`, outwards below 0: one that is free alone, one that is coupled
 * with the needle's axis, whatever the motor there does. The rest of an earlier push is forgotten.
 *
 * @satisfies SWR-BOX-012
 */
void box_push(box_t *self, double mm);

/** Presses or releases pedal, button or handle for good; it is not held from afar then. The handle
 * is pressed with the grip. */
void box_press(box_t *self, box_held_t what, bool is_pressed);

/** Presses pedal, button or handle for `who`, not 0, who must renew it; see box_grip.h. False:
 * another one holds it, and nothing has changed. */
bool box_hold(box_t *self, box_held_t what, uint32_t who);

/** Renews the inputs that `who` holds; one that is not held any more stays open. */
void box_keep(box_t *self, uint32_t who);

/** Releases pedal, button or handle if `who` holds it. */
void box_drop(box_t *self, box_held_t what, uint32_t who);

/** Depth of the needle as the box knows it: its axis, and a free probe beyond. */
double box_depth_mm(const box_t *self);

/** True angle of the needle's base about its line, which counts turns; 0 where no axis turns it. */
double box_turn_rad(const box_t *self);

/**
 * Takes an image of the tip in the z-frame when one is due, and brings those that have come.
 *
 * @satisfies SWR-BOX-775
 */
void box_image_tip(box_t *self);

/**
 * Lets the cards without an axis read the load cells now.
 *
 * @satisfies SWR-BOX-528
 * @satisfies SWR-BOX-532
 */
void box_read_cells(box_t *self);

/** The phantom that the box has of its own: sim_phantom_usual with a force sensor, and none
 * without. */
const sim_phantom_file_t *box_usual_phantom(const robot_t *robot);

/** Writes what there is to see, but for the levels of inputs and lamps, to `seen`. */
void box_show(const box_t *self, bsp_bench_t *seen);

/** Closes or opens `contact` after `delay_us`; 0 is at once. */
void box_contact_set(box_contact_t *contact, bool is_closed, uint32_t delay_us);

#endif
