/* SPDX-License-Identifier: Apache-2.0 */
#ifndef BORESIGHT_EVA_PARTS_H
#define BORESIGHT_EVA_PARTS_H

void follow_axis_chart(void);

void follow_notes(void);

#endif
