/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Board support: everything the control process may ask of the box around it. One implementation is
 * linked per board: a folder of bsp/ with a board.yml.
 *
 * A cycle of control: bsp_sleep_until_ns(), bsp_sample_inputs(), bsp_finish() of what the cycle
 * before has started, the step, bsp_start(). So frames leave in the cycle that made them, and the
 * wire's time costs no waiting.
 */
#ifndef BORESIGHT_BSP_H
#define BORESIGHT_BSP_H

#include "card/card.h"
#include "card/card_dialect.h"
#include "card/card_frame.h"

#include <stdbool.h>
#include <stdint.h>

/** Abilities of a board beside exchanging frames and sampling inputs. */
#define BSP_HAS_EDGE_LATCH 0x1U /**< `dropped` holds pulses shorter than a cycle. */
#define BSP_HAS_DRIVES_OFF 0x2U /**< A line of its own takes the power of all drives. */
#define BSP_HAS_WATCHDOG 0x4U   /**< Something acts when bsp_kick() stays away. */
#define BSP_HAS_LAMPS 0x8U

#define BSP_NAME_SIZE 16U
#define BSP_FIRMWARE_SIZE 40U
#define BSP_ACCEPTED_SIZE 64U

/** Identity of the board that was opened; it stays as it is until the board is closed. */
typedef struct {
    char board[BSP_NAME_SIZE];        /**< As its folder is called. */
    char firmware[BSP_FIRMWARE_SIZE]; /**< Version of its firmware; "" when it has none. */
    uint32_t abilities;               /**< BSP_HAS_ bits. */
    /** Another number each time the box is switched on; never 0. */
    uint32_t power_on;
    /** Frames were exchanged in this power-on before bsp_open(), or that is unknown: axes may have
     * moved. */
    bool was_used;
    /** CRC of the description of the robot that the box belongs to; 0 when that is unknown. */
    uint32_t robot_crc;
    /** It waits for control: a cycle passes when control asks for the next one, so no cycle is late
     * because the machine paused. Never on a real board. */
    bool is_elastic;
    bool is_simulated; /**< No robot is connected: a late cycle hurts no person. */
    uint32_t slowness; /**< Its time passes so many times slower, at best; 1 on a real board. */
    uint32_t speedup;  /**< And up to so many times faster; 1 on a real board. */
    uint32_t dialect;  /**< card_dialect_t of all cards. */
    /** Most by which the time between two samples of a card may be wrong, as the board measures
     * it. */
    uint32_t sample_error_us;
    /** Name of the person who accepts the lacks of cards of another dialect than our own, and the
     * date; "": not accepted. */
    char accepted[BSP_ACCEPTED_SIZE];
} bsp_identity_t;

/** Digital inputs. Each bit is 0 in the state that a cut wire has, which is the safe one. */
#define BSP_IN_PEDAL_A 0x1U        /**< Channel A is closed (pressed). */
#define BSP_IN_PEDAL_B 0x2U        /**< Channel B. */
#define BSP_IN_ESTOP_CHAIN 0x4U    /**< The e-stop chain is closed (not pulled). */
#define BSP_IN_SCANNER_IDLE 0x8U   /**< The scanner does not acquire. */
#define BSP_IN_CONFIRM 0x10U       /**< The box's button is pressed. */
#define BSP_IN_DOSE_BELOW 0x20U    /**< The gate of the treatment: dose not yet reached. */
#define BSP_IN_TREATMENT_MAY 0x40U /**< The same: not stopped. */
#define BSP_IN_ALL 0x7FU

/** The digital inputs, sampled once per cycle. */
typedef struct {
    uint64_t sampled_ns; /**< bsp_now_ns() when the levels were read. */
    uint32_t levels;     /**< BSP_IN_ bits as they are. */
    uint32_t dropped;    /**< BSP_IN_ bits that were 0 at any time since the sample before. */
    /** BSP_IN_ bits that were really read; 0: it is not there, or did not answer. */
    uint32_t valid;
} bsp_inputs_t;

/** Result of one slot's frame. */
typedef enum {
    BSP_SLOT_NOT_SENT = 0,
    /** 256 bytes came back; whether they are a report is not the board's business. */
    BSP_SLOT_OK = 1,
    /** Transferred, but the wire stood still: all bytes 0x00 or all 0xFF. */
    BSP_SLOT_NO_ANSWER = 2,
    BSP_SLOT_LATE = 3,     /**< Not back at the deadline. */
    BSP_SLOT_NOT_IDLE = 4, /**< The exchange before was still under way: not sent. */
    BSP_SLOT_BUS_ERROR = 5 /**< The transport failed; see `error` of the exchange. */
} bsp_slot_result_t;

/** Result of one exchange. */
typedef struct {
    uint64_t started_ns;  /**< bsp_now_ns() of bsp_start(); 0 when there was none. */
    uint64_t finished_ns; /**< Time when the last frame was back, or the deadline. */
    uint32_t received;    /**< Bit n: received[n] holds the answer of slot n. */
    uint64_t sampled_ns[CARD_SLOT_COUNT]; /**< Times of these: bsp_now_ns() when the card was
                                             selected. */
    uint8_t results[CARD_SLOT_COUNT];     /**< bsp_slot_result_t of each slot. */
    int32_t error;                        /**< errno, or the transport's own number; 0: none. */
} bsp_exchange_t;

/** Lamps of the box. */
#define BSP_LAMP_ALIVE 0x1U    /**< Control runs. */
#define BSP_LAMP_MAY_MOVE 0x2U /**< The permit is given: the pedal moves something. */
#define BSP_LAMP_MOVING 0x4U   /**< A drive is on. */
#define BSP_LAMP_FAULT 0x8U    /**< Motion is refused by a fault or the e-stop. */

/**
 * Opens the board at `address` and states its identity. `error` receives one sentence that says
 * what to do.
 *
 * @return false when the board is not there or cannot do what the cycle needs
 *
 * @satisfies SWR-STORE-001
 */
bool bsp_open(const char *address, bsp_identity_t *identity, char *error, uint32_t error_size);

/**
 * Looks at the wires with drives off, before the first cycle: start word found, no bit shift,
 * enough gap of the chip select, each slot empty or alive. Takes up to 100 ms.
 *
 * @return false: `error` holds one sentence that says what to do
 */
bool bsp_self_test(char *error, uint32_t error_size);

/**
 * Begins to exchange frames, full duplex, and returns at once. Bit n of `send` selects slot n. The
 * frames are copied. An exchange that is still under way is not disturbed: the slots of this one
 * are NOT_IDLE.
 *
 * @satisfies SWR-BSP-004
 */
void bsp_start(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES]);

/**
 * Ends the exchange begun last: waits for it until `deadline_ns` at most. received[n] is written
 * where result->received has bit n. May be called once for each bsp_start(); otherwise no slot was
 * sent. A frame that comes back after the deadline is never taken for the answer of a later
 * exchange.
 */
void bsp_finish(uint64_t deadline_ns, uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                bsp_exchange_t *result);

/**
 * Samples the digital inputs. A board with BSP_HAS_EDGE_LATCH latches pulses, however short.
 *
 * @satisfies SWR-ESTOP-004
 */
void bsp_sample_inputs(bsp_inputs_t *inputs);

/** Shows BSP_LAMP_ bits; nothing on a board without lamps. */
void bsp_set_lamps(uint32_t lamps);

/**
 * Takes the power of all drives by a line of its own, without the cards, until the board is opened
 * again; callable from a signal handler. Nothing on a board without BSP_HAS_DRIVES_OFF, and before
 * one is open.
 *
 * @satisfies SWR-BSP-005
 */
void bsp_drives_off(void);

/** Informs the watchdogs that a whole, punctual cycle has passed. */
void bsp_kick(void);

/** The board's monotonic time, ns. Elastic time stands still between two sleeps. */
uint64_t bsp_now_ns(void);

/** The time that the board itself has come to, ns: it stands still while the board does. */
uint64_t bsp_reached_ns(void);

/** Sleeps until `deadline_ns` (absolute, of bsp_now_ns()). */
void bsp_sleep_until_ns(uint64_t deadline_ns);

/**
 * On an elastic board: lets `world_ns` of the world's time pass, or less, in which that of the
 * board stands still, and informs the board that control lives. Nothing on any other board.
 *
 * @satisfies SWR-BOX-007
 */
void bsp_stand_still_ns(uint64_t world_ns);

/** Closes the board; its watchdogs are only disarmed after drives_off was confirmed or the line is
 * off. */
void bsp_close(void);

#endif
