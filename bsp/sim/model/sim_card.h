/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The firmware of a daughter card, as the simulated box runs it, and the reference for the maker of
 * a card (docs/card-protocol.md): takes commands, drives the motor, watches over both, reports. It
 * believes only whole frames whose sequence number is one of the next; after a start or a trip only
 * one that clears the fault with the drive off begins a new sequence.
 */
#ifndef BORESIGHT_SIM_CARD_H
#define BORESIGHT_SIM_CARD_H

#include "card/card_frame.h"
#include "sim/model/sim_encoder.h"
#include "sim/model/sim_motor.h"

#include <stdbool.h>
#include <stdint.h>

#define SIM_CARD_FIRMWARE 0x010200U /**< 1.2.0 */
#define SIM_CARD_DEBOUNCE_US 3000U  /**< A limit switch counts after this time without a change. */
/** The overspeed guard compares counts over this time. */
#define SIM_CARD_SPEED_WINDOW_US 10000U
#define SIM_CARD_SPEED_STEPS 100U /**< The same in steps. */
#define SIM_CARD_MOVING_US 20000U /**< "Moving" lasts this long after an edge. */
#define SIM_CARD_SUPPLY_MV 24000U

/** State of one card. */
typedef struct {
    uint32_t slot;
    uint32_t card_type;
    bool has_magnitudes; /**< Its driver obeys those of a drive without pwm. */
    uint32_t firmware;
    uint32_t limit_bit;       /**< CARD_LIMIT_ bit of the connected switch, 0 without one. */
    uint32_t clock_offset_us; /**< Card time minus box time. */
    uint32_t time_us;         /**< Box time of the last step's end. */
    uint64_t uptime_us;
    card_command_t command; /**< The last one accepted. */
    bool has_command;
    bool has_sequence;     /**< No trip since `command` began one. */
    card_drive_t applied;  /**< Drive that the driver applies now. */
    uint32_t faults;       /**< Latched CARD_STATUS_ bits. */
    uint32_t passing;      /**< CARD_STATUS_ bits of the next report only. */
    uint32_t valid_age_us; /**< Since the last valid frame. */
    bool is_watched;       /**< The watchdog runs: a valid frame has come since start or trip. */
    bool limit_raw;
    bool limit_debounced;
    uint32_t limit_stable_us;
    int32_t count;                        /**< Encoder reading of the last step. */
    int32_t window[SIM_CARD_SPEED_STEPS]; /**< Readings of the last SIM_CARD_SPEED_WINDOW_US. */
    uint32_t window_at;
    uint32_t
        even_steps; /**< So many of the newest readings are `count`, all of the window at most. */
    uint32_t heartbeat;
    uint32_t rx_crc_errors;
    uint32_t sequence_gaps;
    uint32_t watchdog_trips;
    double motor_temperature_c;
    sim_heat_t heat;         /**< Heat of its motor. */
    bool is_motor_hot;       /**< Its motor is as hot as none may be. */
    double feigned_driver_c; /**< Temperature it measures at its driver; 0: the true one. */
    uint32_t supply_mv;      /**< Supply it measures while it has power. */
    uint32_t adc[4];         /**< Readings of its converters, 16 bits each. */
    bool is_powered;
} sim_card_t;

/** A card just switched on at `time_us`, drive off, its encoder at rest. */
void sim_card_init(sim_card_t *self, const axis_config_t *axis, const sim_encoder_t *encoder,
                   bool is_limit_active, uint32_t time_us);

/**
 * Takes the 256 bytes of an exchange. A damaged frame, or one out of sequence, changes nothing but
 * a count; one whose drive does not suit the card is a driver fault.
 *
 * @satisfies SWR-BOX-008
 * @satisfies SWR-BOX-009
 * @satisfies SWR-CARD-010
 */
void sim_card_receive(sim_card_t *self, const uint8_t bytes[CARD_FRAME_BYTES]);

/**
 * Advances by SIM_STEP_US with what the card's inputs show at the end of the step.
 *
 * @satisfies SWR-BOX-001
 */
void sim_card_step(sim_card_t *self, const sim_encoder_t *encoder, bool is_limit_active,
                   bool is_powered);

/** As `steps` of sim_card_step() while the encoder and the switch stand. */
void sim_card_rest(sim_card_t *self, const sim_encoder_t *encoder, bool is_limit_active,
                   bool is_powered, uint32_t steps);

/** Writes the report of this moment; edges are counted from here anew. */
void sim_card_report(sim_card_t *self, sim_encoder_t *encoder, uint8_t bytes[CARD_FRAME_BYTES]);

#endif
