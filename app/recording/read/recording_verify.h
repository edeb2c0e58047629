/* SPDX-License-Identifier: Apache-2.0 */
/** @file Whether a recording is as it was written, and where it is not. Private to the reader. */
#ifndef BORESIGHT_RECORDING_VERIFY_H
#define BORESIGHT_RECORDING_VERIFY_H

#include "recording/read/recording_state.h"

/** Notes what was found, as a sentence. @return `verdict` */
recording_verdict_t recording_find(recording_finding_t *finding, recording_verdict_t verdict,
                                   const char *format, ...) __attribute__((format(printf, 3, 4)));

/** Verifies every byte of the mapped file, which has room for a header; counts blocks and records.
 */
recording_verdict_t recording_verify(recording_reader_t *self, recording_finding_t *finding);

#endif
