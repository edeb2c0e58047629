/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The wire between the simulated control box (a process) and those who use it: a shared-memory
 * segment with one frame exchange, the input levels and one order under way. The holders of its
 * ends show by locks on the segment that the kernel drops with their process, so a killed one
 * leaves nothing to clean up.
 */
#ifndef BORESIGHT_WIRE_H
#define BORESIGHT_WIRE_H

#include "bsp.h"
#include "bsp_bench.h"
#include "sim/box.h"
#include "sim/box_clock.h"

#include <stdbool.h>
#include <stdint.h>

/** As board.yml has it: the box of an instance is called like that, and this. */
#define WIRE_NAME_ENDING "-box"
#define WIRE_DEFAULT_NAME "boresight" WIRE_NAME_ENDING
/** Environment variable that selects another instance. */
#define WIRE_NAME_VARIABLE "BORESIGHT_BOX"
#define WIRE_ORDER_SIZE 128U

/** The segment. Words that both sides touch are accessed by wire_load() and wire_store() only. */
typedef struct {
    uint64_t time_us;    /**< The box's time; see box_clock.h. */
    uint64_t wanted_us;  /**< Elastic time: when, in the box's time, the exchange is to be; */
    uint64_t replied_us; /**< When, in the box's time, it was; */
    uint64_t called_us;  /**< and what time the box is called to come to, after it. */
    uint32_t magic;      /**< Set last, when the rest is ready. */
    uint32_t wake;       /**< Grows with each thing for the box to do; the box sleeps on it. */
    uint32_t beat;       /**< Grows each time the box has looked around, at least every 1.5 ms. */
    uint32_t is_elastic; /**< box_time_t of the box: 0 or 1 */
    uint32_t slowness;   /**< and 1 .. LIMIT_BOX_SLOWEST */
    uint32_t speedup;    /**< and 1 .. LIMIT_BOX_FASTEST. */
    uint32_t pace;       /**< 1 .. speedup: how many times faster time passes now, at most. */
    uint32_t power_on;   /**< As bsp_identity_t. */
    uint32_t is_used;    /**< 1 after the first exchange that may have moved something. */
    uint32_t robot_crc;  /**< CRC of the description of the robot that is simulated. */
    uint32_t openings;   /**< Grows when control takes its end. */
    uint32_t inputs;     /**< BSP_IN_ bits. */
    uint32_t dropped;    /**< BSP_IN_ bits that were 0 since control took them. */
    uint32_t lamps;      /**< BSP_LAMP_ bits. */
    uint32_t is_off;     /**< 1: the amplifier-off line is set. */
    uint32_t call;       /**< Number of the newest call, */
    uint32_t come;       /**< and of the newest one obeyed; control sleeps on it. */
    uint32_t request;    /**< Number of the newest exchange asked for. */
    uint32_t reply;      /**< Number of the newest exchange answered; control sleeps on it. */
    uint32_t waits;      /**< Grows while control lives and asks for nothing. */
    uint32_t send;
    uint32_t received;
    uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    uint8_t replies[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    uint32_t order_request; /**< The same for orders. */
    uint32_t order_reply;
    uint32_t order_done; /**< 1: carried out, 0: refused. */
    char order[WIRE_ORDER_SIZE];
    char answer[BOX_REPLY_SIZE];
    uint32_t bench_edition; /**< Grows before and after the next is written: odd meanwhile. */
    bsp_bench_t bench;      /**< State of the box after the orders. */
} wire_t;

/** The ends of the wire; each can be held by one process. A process that only looks takes none. */
typedef enum {
    WIRE_END_BOX = 0,
    WIRE_END_CONTROL = 1,
    WIRE_END_ORDERS = 2,
    WIRE_END_NONE = 3
} wire_end_t;

/** One process' hold of a wire. */
typedef struct {
    wire_t *wire; /**< NULL while not open. */
    int file;
    char path[64];
} wire_port_t;

/**
 * Makes the wire `name` and takes the box's end. A wire left by a killed box is taken over together
 * with the processes that are still attached; then its time goes on, and must pass as before. Each
 * call is a power-on of its own. On false `error` holds a sentence.
 */
bool wire_serve(wire_port_t *port, const char *name, box_time_t time, char *error,
                uint32_t error_size);

/** Takes another end of the wire `name`; on false `error` holds a sentence that says what to do. */
bool wire_attach(wire_port_t *port, const char *name, wire_end_t end, char *error,
                 uint32_t error_size);

/** A living process holds the box's end. */
bool wire_is_served(const wire_port_t *port);

/** Lets go; the box's end also removes the name. */
void wire_close(wire_port_t *port, wire_end_t end);

uint32_t wire_load(const uint32_t *word);
void wire_store(uint32_t *word, uint32_t value);

/** Sets `bits` of a word; takes all of them away. */
void wire_latch(uint32_t *word, uint32_t bits);
uint32_t wire_take(uint32_t *word);

uint64_t wire_load_time(const wire_t *wire);
void wire_store_time(wire_t *wire, uint64_t time_us);

/** Informs the box that there is something to do. */
void wire_wake_box(wire_t *wire);

/** Stores `value` and wakes the process that sleeps on `word`. */
void wire_announce(uint32_t *word, uint32_t value);

/** Sleeps while `*word` is `value`, at most `timeout_us`; may return early. */
void wire_sleep(const uint32_t *word, uint32_t value, uint32_t timeout_us);

/** Waits until `*word` is `value`; false when it is not within `timeout_us`. */
bool wire_await(const uint32_t *word, uint32_t value, uint32_t timeout_us);

/**
 * Hands the box an order and waits for its answer; false when there is none within `timeout_us`,
 * and the order is withdrawn then.
 *
 * @satisfies SWR-BOX-022
 */
bool wire_give_order(wire_t *wire, const char *order, uint32_t timeout_us);

/**
 * Lets the box' time pass at most `pace` times faster from now on. False: it is not from 1 to the
 * speedup of the box.
 *
 * @satisfies SWR-BOX-046
 */
bool wire_set_pace(wire_t *wire, uint32_t pace);

/** The pace, which is always from 1 to the speedup. */
uint32_t wire_pace(const wire_t *wire);

/** Shows what orders have made of the box. One process at a time. */
void wire_show_bench(wire_t *wire, const bsp_bench_t *bench);

/**
 * Copies what was shown last, whole. False: it was being written all the time, by a box that has
 * ended in the middle of it.
 *
 * @satisfies SWR-BOX-023
 */
bool wire_see_bench(const wire_t *wire, bsp_bench_t *seen);

/** The monotonic clock of the world. */
uint64_t wire_now_ns(void);
uint64_t wire_now_us(void);

#endif
