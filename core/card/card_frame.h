/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The frames between controller and daughter card: 64 big-endian words of 32 bit, both ways in one
 * full-duplex exchange. A command goes out, a report comes back; the report speaks of the command
 * of the exchange before. Both directions are coded here, so that the card's side (the simulated
 * box) shares the one layout.
 */
#ifndef BORESIGHT_CARD_FRAME_H
#define BORESIGHT_CARD_FRAME_H

#include "card/card.h"
#include "interface/card_frame_result.h"

#include <stdbool.h>
#include <stdint.h>

#define CARD_FRAME_WORDS 64U
#define CARD_FRAME_BYTES 256U
#define CARD_FRAME_START 0xFEFEFE01U
#define CARD_FRAME_PROTOCOL 1U

/** Values of the drive mode, word 10 of a command. */
typedef enum {
    CARD_DRIVE_OFF = 0,            /**< No drive; every drive word is 0. */
    CARD_DRIVE_PWM = 1,            /**< Speed by the duty. */
    CARD_DRIVE_NON_PWM = 2,        /**< Runs; by the magnitude where the card has one. */
    CARD_DRIVE_HIGH_FREQUENCY = 3, /**< Speed by the frequency of the waves. */
    CARD_DRIVE_ANALOG = 4          /**< Speed by the converter. */
} card_drive_mode_t;

/** Bits of the system state, word 4 of a command. */
#define CARD_SYSTEM_PEDAL 0x01U   /**< The gate of the pedal is open. */
#define CARD_SYSTEM_ESTOP 0x02U   /**< The e-stop is pulled. */
#define CARD_SYSTEM_PERMIT 0x04U  /**< The axis may move in this cycle. */
#define CARD_SYSTEM_HOMING 0x08U  /**< The robot homes. */
#define CARD_SYSTEM_SCANNER 0x10U /**< The scanner acquires. */

/** Bits of the control word 5 of a command. */
#define CARD_CONTROL_AMPLIFIER 0x01U   /**< The driver may have power. */
#define CARD_CONTROL_CLEAR_FAULT 0x02U /**< Forget every fault, and begin a sequence. */

/** As `edges` of a report: when an edge came is known by the cycle only. */
#define CARD_EDGES_UNKNOWN 0xFFFFFFFFU

#define CARD_NO_AXIS 0xFFFFFFFFU /**< Word 17 of a command: the card has none. */

/** Bits of the status word 7 of a report. */
#define CARD_STATUS_AMPLIFIER_ON 0x0001U /**< The driver has power. */
#define CARD_STATUS_MOVING 0x0002U       /**< The encoder counted in the last 20 ms. */
#define CARD_STATUS_DRIVER_FAULT 0x0004U /**< Driver failed, or a drive that it has not. */
#define CARD_STATUS_WATCHDOG 0x0008U     /**< Tripped since the last clear-fault. */
#define CARD_STATUS_HOT 0x0010U          /**< Driver or motor too hot. */
#define CARD_STATUS_OVERSPEED 0x0020U    /**< Faster than the command allows. */
#define CARD_STATUS_GUARD 0x0040U        /**< The reading left the guards of the command. */
#define CARD_STATUS_ILLEGAL_EDGE 0x0080U /**< Both encoder lines changed at once. */
#define CARD_STATUS_RX_CRC 0x0100U       /**< A command with damage since the last report. */
#define CARD_STATUS_POWER_BAD 0x0200U    /**< The supply cannot feed the driver. */
/** Any of these means that the card must not be trusted to drive. */
#define CARD_STATUS_FAULTS                                                                         \
    (CARD_STATUS_DRIVER_FAULT | CARD_STATUS_WATCHDOG | CARD_STATUS_HOT | CARD_STATUS_OVERSPEED |   \
     CARD_STATUS_GUARD | CARD_STATUS_POWER_BAD)

/** Bits of the debounced limit switches of a report; 1 = active. */
#define CARD_LIMIT_LOWER 0x01U /**< At the lower end. */
#define CARD_LIMIT_UPPER 0x02U /**< At the upper end. */

/** Drive that a card is asked to apply to its motor. All zero is "off". */
typedef struct {
    uint32_t mode;      /**< card_drive_mode_t. */
    uint32_t direction; /**< 0 or 1; the meaning is the robot's. */
    /** 0..0x7FFFFF; without pwm a magnitude, 0 if the card runs or stops. High frequency: the word
     * of both waves, LIMIT_WAVE_FASTEST_WORD..LIMIT_WAVE_SLOWEST_WORD, of which the smaller is the
     * faster. Analog: 0..0xFFFF. */
    uint32_t duty;
    uint32_t amplitude; /**< High frequency: of both waves, 1..255. Otherwise 0. */
} card_drive_t;

/** Controller to card. */
typedef struct {
    uint32_t slot;
    uint32_t sequence;     /**< Grows by one each exchange. */
    uint32_t time_us;      /**< Controller time, wraps. */
    uint32_t system_state; /**< CARD_SYSTEM_ bits, mode in bits 8..15. */
    uint32_t control;      /**< CARD_CONTROL_ bits. */
    card_drive_t drive;
    /** The card switches its drive off after this time without a valid frame. */
    uint32_t watchdog_us;
    uint32_t overspeed_ticks_per_s;
    int32_t guard_minimum_ticks; /**< Raw encoder counts beyond which the card switches off. */
    int32_t guard_maximum_ticks;
    uint32_t axis_id; /**< Or CARD_NO_AXIS. */
} card_command_t;

/** Card to controller. */
typedef struct {
    uint32_t slot;
    uint32_t accepted_sequence; /**< Sequence of the last command the card accepted. */
    uint32_t heartbeat;         /**< Grows by one each report; a repeated value is an old report. */
    uint32_t time_us;           /**< Card time, wraps. */
    uint32_t card_type;         /**< card_type_t. */
    uint32_t firmware;          /**< major << 16 | minor << 8 | patch. */
    uint32_t system_state;      /**< Echo. */
    uint32_t status;            /**< CARD_STATUS_ bits. */
    uint32_t limits_raw;        /**< CARD_LIMIT_ bits. */
    uint32_t limits;            /**< CARD_LIMIT_ bits, debounced. */
    int32_t encoder_count;
    uint32_t last_edge_us;         /**< Card time of the newest encoder edge. */
    uint32_t fourth_edge_us;       /**< Card time of the edge four edges earlier. */
    uint32_t edges;                /**< Since the last report, saturates at 65535. */
    uint32_t illegal_edges;        /**< Since the last report, saturates at 65535. */
    int32_t driver_temperature_dc; /**< 0.1 degree Celsius. */
    int32_t motor_temperature_dc;
    uint32_t supply_mv;
    uint32_t current_ma;
    uint32_t adc_words[CARD_ADC_WORDS]; /**< Converters 1 and 2, 3 and 4; 16 bits each, the first
                                           one high. */
    card_drive_t applied;               /**< Drive that the card's driver applies now. */
    uint32_t rx_crc_errors;
    uint32_t sequence_gaps;
    uint32_t watchdog_trips;
    uint32_t uptime_s;
} card_report_t;

/** @return the card_drive_mode_t of the drives of a card_type_t; CARD_DRIVE_OFF: it has none */
static inline uint32_t card_drive_mode_of(uint32_t card_type)
{
    static const uint8_t modes[CARD_TYPES] = {
        [CARD_TYPE_PWM] = (uint8_t)CARD_DRIVE_PWM,
        [CARD_TYPE_NON_PWM] = (uint8_t)CARD_DRIVE_NON_PWM,
        [CARD_TYPE_HIGH_FREQUENCY] = (uint8_t)CARD_DRIVE_HIGH_FREQUENCY,
        [CARD_TYPE_ANALOG] = (uint8_t)CARD_DRIVE_ANALOG,
    };
    return (card_type < CARD_TYPES) ? (uint32_t)modes[card_type] : (uint32_t)CARD_DRIVE_OFF;
}

/**
 * Writes `command` as the 256 bytes of a frame. A value that no drive has goes out as one that is
 * refused.
 *
 * @satisfies SWR-CARD-001
 * @satisfies SWR-CARD-002
 * @satisfies SWR-CARD-004
 * @satisfies SWR-CARD-007
 * @satisfies SWR-CARD-009
 * @satisfies SWR-DRIVE-001
 * @satisfies SWR-DRIVE-002
 */
void card_frame_encode_command(const card_command_t *command, uint8_t bytes[CARD_FRAME_BYTES]);

/** The same onto bytes that are zero: for the cycle, which clears all frames in one go. */
void card_frame_write_command(const card_command_t *command, uint8_t bytes[CARD_FRAME_BYTES]);

/** Writes `report` as the 256 bytes of a frame. */
void card_frame_encode_report(const card_report_t *report, uint8_t bytes[CARD_FRAME_BYTES]);

/**
 * Reads a command sent to `slot`. On any result but CARD_FRAME_OK `command` is unchanged.
 *
 * @satisfies SWR-CARD-003
 * @satisfies SWR-CARD-006
 * @satisfies SWR-DRIVE-003
 */
card_frame_result_t card_frame_decode_command(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t slot,
                                              card_command_t *command);

/** The heartbeat of a report, whether it is valid or not. */
uint32_t card_frame_heartbeat(const uint8_t bytes[CARD_FRAME_BYTES]);

/**
 * Reads a report of `slot`. On any result but CARD_FRAME_OK `report` is unchanged.
 *
 * @satisfies SWR-CARD-003
 * @satisfies SWR-CARD-006
 * @satisfies SWR-DRIVE-003
 */
card_frame_result_t card_frame_decode_report(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t slot,
                                             card_report_t *report);

#endif
