/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The black box: takes every cycle out of its lane into recordings, each of which begins with a
 * checkpoint where possible, so that it can be replayed without those before it. While the disk is
 * full or the folder cannot be written, control is informed and hands over nothing; recording
 * continues with the records that wait in the lane. When the recorder cannot keep up, the lane of
 * cycles fills: in elastic time control waits for it, otherwise what was lost is said and counted
 * in the next recording. A record stays in the lane until it is in the file. The cycles of a file
 * that is removed, moved, replaced or shortened by another are counted, whichever file of this
 * black box it is.
 */
#ifndef BORESIGHT_BLACK_BOX_H
#define BORESIGHT_BLACK_BOX_H

#include "exchange/exchange.h"
#include "exchange/exchange_cycles.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_rows.h"
#include "limits/requirement_limits.h"
#include "recording/write/recording_room.h"
#include "recording/write/run_files.h"

#include <stdbool.h>

#define BLACK_BOX_FILE_US UINT64_C(600000000)                  /**< A new file after ten minutes. */
#define BLACK_BOX_RETRY_US ((uint64_t)LIMIT_RECORDER_RETRY_US) /**< Between attempts to write. */

typedef struct {
    exchange_t *exchange;
    run_files_t files;
    uint64_t requested_us; /**< When a checkpoint was last asked for; 0 when none is awaited. */
    uint64_t retry_us;     /**< Not before then is another file tried. */
    uint32_t removed;      /**< Cycles of files that others have removed or shortened. */
    bool is_failing;       /**< The last attempt to write failed, and it was said. */
    uint64_t damaged_us;   /**< When damage of the lane was last found; 0: never. */
    uint64_t looked_us;    /**< When the earlier files were last looked at. */
    recording_room_t room;
    cycle_record_t record;                        /**< The present one. */
    trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS]; /**< Rows of the newest checkpoint. */
} black_box_t;

/**
 * Begins with an empty file at the first record, and asks control for a checkpoint. `header` needs
 * no run: it is that of `exchange`.
 *
 * @satisfies SWR-REC-030
 */
void black_box_open(black_box_t *self, const char *directory, exchange_t *exchange,
                    const recording_header_t *header);

/**
 * Records everything that waits in the cycle lane. `now_us` is monotonic.
 *
 * @satisfies SWR-LOAD-001
 * @satisfies SWR-REC-012
 * @satisfies SWR-REC-013
 * @satisfies SWR-REC-014
 */
void black_box_drain(black_box_t *self, uint64_t now_us);

/**
 * Closes the present file with its trailer, which says that the run ends with it if control has
 * ended and the file has its last cycle.
 *
 * @return the number of cycles at the end of the run that are in no recording, which was reported;
 * 0 as well while control runs and the recorder can write: the next one goes on
 *
 * @satisfies SWR-REC-031
 * @satisfies SWR-REC-040
 */
uint32_t black_box_close(black_box_t *self);

#endif
