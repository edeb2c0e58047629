/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The one place where the processes meet: a shared-memory segment of fixed layout, but for the
 * lane of cycles, whose capacity its creator chooses. `control` writes and never waits (in elastic
 * time it waits for the recorder, before a cycle: control/cycle_lane.h); everyone else reads or
 * asks. One writer and one reader per lane; the event ring has many readers. A stop is no command
 * in a lane but a latch, which cannot be full.
 */
#ifndef BORESIGHT_EXCHANGE_H
#define BORESIGHT_EXCHANGE_H

#include "controller/controller.h"
#include "exchange/exchange_record.h"
#include "exchange/exchange_values.h"
#include "interface/answer.h"
#include "interface/command.h"
#include "interface/event.h"
#include "interface/loop_figures.h"
#include "interface/snapshot.h"
#include "interface/status.h"

#include <stdbool.h>
#include <stdint.h>

#define EXCHANGE_CYCLES_MOST 0x100000U

/** Real-time rights that control asked for; a set bit was granted. */
#define EXCHANGE_RIGHT_FIFO 0x1U   /**< SCHED_FIFO. */
#define EXCHANGE_RIGHT_CORE 0x2U   /**< A core of its own. */
#define EXCHANGE_RIGHT_MEMORY 0x4U /**< Locked memory. */

typedef struct exchange exchange_t;

/**
 * Creates the segment `name` (1 to 62 characters without a slash), replacing one whose creator is
 * dead. `cycles`: entries of the lane of cycles, 1 to EXCHANGE_CYCLES_MOST. NULL with a sentence in
 * `error` when it cannot, or when a living creator has it.
 */
exchange_t *exchange_create(const char *name, uint32_t cycles, char *error, uint32_t error_size);

/** Whether a living process has created the segment `name`, or one that this user may not open. */
bool exchange_is_used(const char *name);

/**
 * Opens the segment `name`. NULL with a sentence in `error` when it is missing or its layout is
 * another build's.
 *
 * @satisfies SWR-EXCH-004
 */
exchange_t *exchange_open(const char *name, char *error, uint32_t error_size);

/**
 * Makes everything that only control writes read-only for this process, and what only the recorder
 * writes unless `process` is the recorder. Called once after exchange_open() by every process but
 * control and the creator.
 *
 * @satisfies SWR-EXCH-026
 */
void exchange_protect(exchange_t *self, exchange_process_t process);

/**
 * For control, before its loop: writes each page of what it publishes once, and changes nothing. A
 * Cortex-A9 has no bit of its own for a page that was written: locked or not, the first write to a
 * page waits for the kernel.
 *
 * @satisfies SWR-ARM-007
 */
void exchange_touch(exchange_t *self);

/**
 * The run: what control does in this exchange from its cycle 0 on, whichever processes beside it
 * are replaced. Its number is when the exchange was created, in us of UTC since 1970.
 */
uint64_t exchange_run(const exchange_t *self);

/** For the creator: control has ended, so no cycle follows. */
void exchange_note_control_ended(exchange_t *self);
bool exchange_has_control_ended(const exchange_t *self);

/** Unmaps; the creator also removes the name. `self` is gone afterwards. */
void exchange_close(exchange_t *self);

/** Alive counter of `process`. */
void exchange_beat(exchange_t *self, exchange_process_t process);
uint32_t exchange_beats(const exchange_t *self, exchange_process_t process);

/** For the supervisor: it has replaced `process`, which gave no sign of life. */
void exchange_note_replaced(exchange_t *self, exchange_process_t process);

/** For http, which logs it: the number of replacements of `process` since the call before. */
uint32_t exchange_take_replaced(exchange_t *self, exchange_process_t process);

/** Publishes `robot`, once, before anything else. */
void exchange_publish_robot(exchange_t *self, const robot_t *robot);

/**
 * The robot that control drives, as long as the exchange is open; of no axes until control has
 * published it, which it does before its first snapshot. No process but control needs a table.
 *
 * @satisfies SWR-ROBOT-015
 */
const robot_t *exchange_robot(const exchange_t *self);

/** The same of its cards, published before the robot. */
void exchange_publish_cards(exchange_t *self, const exchange_cards_t *cards);
const exchange_cards_t *exchange_cards(const exchange_t *self);

/**
 * Publishes; never waits.
 *
 * @satisfies SWR-EXCH-001
 */
void exchange_publish_snapshot(exchange_t *self, const snapshot_t *snapshot);

/** Copies the newest whole snapshot. False before the first one, or when the writer kept
 * interfering. */
bool exchange_read_snapshot(const exchange_t *self, snapshot_t *snapshot);

void exchange_publish_loop(exchange_t *self, const loop_figures_t *figures);

/** Copies the newest loop figures. False before the first ones, or when the writer kept
 * interfering. */
bool exchange_read_loop(const exchange_t *self, loop_figures_t *figures);

/**
 * Puts a command into the lane of its source. One thread at a time for each source.
 *
 * @return STATUS_OK; STATUS_BUSY when EXCHANGE_COMMANDS wait, for STOP and EMERGENCY EXCHANGE_STOPS
 * more; STATUS_NOT_ALLOWED for what is no source, and for STOP and EMERGENCY of
 * COMMAND_SOURCE_HTTP, which are requested (nothing is queued)
 *
 * @satisfies SWR-EXCH-002
 */
status_t exchange_send_command(exchange_t *self, const command_t *command);

/**
 * Asks for STOP, or EMERGENCY, as COMMAND_SOURCE_HTTP. It waits in no lane that could be full. Any
 * thread of any process.
 *
 * @return the request's number
 *
 * @satisfies SWR-HTTP-008
 * @satisfies SWR-HTTP-030
 */
uint32_t exchange_request_stop(exchange_t *self, workphase_t workphase);

/** Control's answer to the stop request `number` or, as one stop serves all, to a later one. False
 * while none exists. */
bool exchange_read_stop_answer(const exchange_t *self, uint32_t number, answer_t *answer);

/** Where stops are listened for, noted for the next run of the HTTP server; 0: not noted. */
void exchange_note_stop_port(exchange_t *self, uint32_t port);
uint32_t exchange_stop_port(const exchange_t *self);

/**
 * Takes up to `most` (1 at least) commands in their order, none after one that computes kinematics,
 * but a requested stop as the last of them. The lanes take turns. A command that came before a
 * stop, or before STOP or EMERGENCY in its lane, or waits in another lane by then, is answered as
 * refused with STATUS_DISCARDED instead.
 *
 * @satisfies SWR-CTRL-021
 * @satisfies SWR-EXCH-015
 * @satisfies SWR-CMD-007
 * @satisfies SWR-TRAJ-018
 */
uint32_t exchange_take_commands(exchange_t *self, command_t *commands, uint32_t most);

/**
 * How often the lane of `source` was found damaged since the start: its head set right, or a
 * command in it dropped that its source had not put there.
 *
 * @satisfies SWR-EXCH-021
 */
uint32_t exchange_lane_damages(const exchange_t *self, command_source_t source);

/** Hands an answer to its source; false (and counted) when the reader of the lane has let it fill
 * up. */
bool exchange_push_answer(exchange_t *self, const answer_t *answer);

/**
 * For the one who asks as `source`: its next answer since it opened the exchange; false when there
 * is none.
 *
 * @satisfies SWR-EXCH-023
 */
bool exchange_take_answer(exchange_t *self, command_source_t source, answer_t *answer);

/** Answers that found the lane full or had no source to go to, since the start. */
uint32_t exchange_answers_lost(const exchange_t *self);

/**
 * Adds an event, numbered by the controller without gaps, to the ring; the oldest is overwritten.
 *
 * @satisfies SWR-EVENT-013
 */
void exchange_push_event(exchange_t *self, const event_t *event, uint64_t utc_us);

/**
 * Copies events from number `*next` on, at most `most`, and advances `*next`. Events already
 * overwritten are skipped and added to `*lost`.
 *
 * @return events copied
 */
uint32_t exchange_read_events(const exchange_t *self, uint32_t *next, exchange_event_t *events,
                              uint32_t most, uint32_t *lost);

/** Number of the oldest event that is kept; where none exists, of the first one. */
uint32_t exchange_oldest_event(const exchange_t *self);

/** Up to which event the log has them, noted for the next run of the recorder: the number of the
 * next one; 0: not noted. */
void exchange_note_logged(exchange_t *self, uint32_t next);
uint32_t exchange_logged(const exchange_t *self);

/** For a recorder that begins or has lost cycles: control pushes a checkpoint in its next cycle. */
void exchange_request_checkpoint(exchange_t *self);

/** For control: says once whether a checkpoint was asked for since the last call. */
bool exchange_take_checkpoint_request(exchange_t *self);

/** For a replacement of the running programs: control shall end in its next cycle if it is at rest
 * then. */
void exchange_request_end(exchange_t *self);

/** For control: says once whether that was asked for since the last call. */
bool exchange_take_end_request(exchange_t *self);

#endif
