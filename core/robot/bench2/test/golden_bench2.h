/* SPDX-License-Identifier: Apache-2.0 */
/** @file Golden figures of the bench, worked out by hand: joints in mm and where they put the
 * treatment point. */
#ifndef BORESIGHT_GOLDEN_BENCH2_H
#define BORESIGHT_GOLDEN_BENCH2_H

#include <stdint.h>

typedef struct {
    int32_t slide_nm;
    int32_t needle_nm;
    int32_t point_nm[3];
} golden_bench2_t;

static const golden_bench2_t golden_bench2[] = {
    {0, 0, {0, 100000000, 50000000}},
    {-60000000, 0, {-60000000, 100000000, 50000000}},
    {0, 30000000, {0, 70000000, 50000000}},
    {-25500000, 12250000, {-25500000, 87750000, 50000000}},
};

#endif
