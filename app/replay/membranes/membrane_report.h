/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The membrane detector of the core on recordings of force and depth, each of one insertion: a line
 * for each event, and how it did against the depths that were given. The program owns one.
 */
#ifndef BORESIGHT_MEMBRANE_REPORT_H
#define BORESIGHT_MEMBRANE_REPORT_H

#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <stdint.h>

/** All zero at first. */
typedef struct {
    int32_t depths_um[LIMIT_MEMBRANES_MOST]; /**< Membranes that each insertion has. */
    uint32_t expected;                       /**< Their number. */
    uint32_t noise_un;                       /**< Behind the filter. */
    bool has_noise;                          /**< It was given, and is not measured. */
    uint32_t insertions;
    uint32_t passed; /**< Expected membranes that were found or missed. */
    uint32_t found;
    uint32_t false_alarms;    /**< Punctures that are no membrane. */
    uint32_t false_in_window; /**< Those of them within the window of one. */
} membrane_report_t;

/**
 * Takes depths in mm, separated by commas.
 *
 * @return false: it is no list of up to LIMIT_MEMBRANES_MOST numbers from 0 to
 * LIMIT_MEMBRANE_DEEPEST_UM that rise
 */
bool membrane_report_expect(membrane_report_t *self, const char *text);

/**
 * Takes the standard deviation of the filtered force in mN.
 *
 * @return false: it is no decimal number from 0 to 10,000
 */
bool membrane_report_take_noise(membrane_report_t *self, const char *text);

/**
 * Writes the events of the insertion in the file `path` to the standard output. Without a noise
 * that was given it measures that of the first second, in which the needle has to rest.
 *
 * @return false: the file was refused, with a sentence on the standard error; nothing was written
 *
 * @satisfies SWR-PUNCT-552
 */
bool membrane_report_file(membrane_report_t *self, const char *path);

/**
 * Writes how it did, if membranes were expected.
 *
 * @satisfies SWR-PUNCT-553
 */
void membrane_report_end(const membrane_report_t *self);

#endif
