/* SPDX-License-Identifier: Apache-2.0 */
#ifndef BORESIGHT_EVA_SUMS_H
#define BORESIGHT_EVA_SUMS_H

void follow_sums(void);

void follow_frames(void);

void follow_trace(void);

#endif
