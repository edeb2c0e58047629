/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The fields of a structure as series that people plot: each has a name that ends in its unit, and
 * a number, a flag or a word. core/interface says what they are.
 */
#ifndef BORESIGHT_SERIES_H
#define BORESIGHT_SERIES_H

#include "interface/app/fields.h"
#include "robot/robot.h"

#define SERIES_NAME_SIZE 80U
#define SERIES_WORD_SIZE 512U

typedef enum { SERIES_NUMBER, SERIES_FLAG, SERIES_WORD } series_kind_t;

/** A series, and what it is now. */
typedef struct {
    char name[SERIES_NAME_SIZE];
    const char *says;
    series_kind_t kind;
    double number; /**< For a flag 0 or 1. */
    int decimals;  /**< All that it has. */
    char word[SERIES_WORD_SIZE];
} series_t;

typedef void series_sink_t(void *to, const series_t *series);

/**
 * Gives `sink` each series of the structure at `from`, without those of arrays of structures. With
 * `axis` positions and speeds are given in its unit as well.
 */
void series_report(const field_t *fields, const void *from, const axis_config_t *axis,
                   series_sink_t *sink, void *to);

/** Writes what it is now, "none" for no word. */
void series_write(const series_t *self, char *text, size_t size);

/** A number that differs when a flag, a word or a set of it does, those of arrays of structures
 * with them. */
uint32_t series_states(const field_t *fields, const void *from);

#endif
