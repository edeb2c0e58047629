/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The phantom of a simulated box: tissue in front of the needle, how it bends the needle and moves
 * a target, and the properties of the two load cells and of images of the tip. A phantom is a text,
 * one key with its number in each line; "layer" begins a layer, and "cell hand" or "cell needle"
 * the properties of a cell. A line that is empty or begins with # has no meaning. Each key stands
 * once where it belongs, and none may be missing. The parts "needle", "target" and "images" may:
 * without them the needle is never bent, and there is no target and no image.
 */
#ifndef BORESIGHT_SIM_PHANTOM_H
#define BORESIGHT_SIM_PHANTOM_H

#include "sim/model/sim_bevel.h"
#include "sim/model/sim_imager.h"
#include "sim/model/sim_load_cell.h"
#include "sim/model/sim_target.h"
#include "sim/model/sim_tissue.h"

#include <stdbool.h>
#include <stdint.h>

/** The load cells. */
typedef enum { SIM_CELL_HAND = 0, SIM_CELL_NEEDLE = 1 } sim_cell_t;
#define SIM_CELLS 2U

#define SIM_PHANTOM_SIZE 8192U /**< Room for any phantom as text. */

/** All zero: nothing is in front of the needle, and the cells are ideal. */
typedef struct {
    sim_phantom_t tissue;
    sim_load_cell_config_t cells[SIM_CELLS];
    sim_bevel_config_t needle;
    sim_target_t target;
    sim_imager_config_t images;
} sim_phantom_file_t;

/**
 * The phantom that a robot with a force sensor has if no other is given: two membranes. All figures
 * are within published ranges of soft tissue, and none is that of a certain patient.
 *
 * @satisfies SWR-BOX-531
 */
extern const sim_phantom_file_t sim_phantom_usual;

/** A target of that phantom, straight ahead at first, that moves by 5 mm. */
extern const sim_target_t sim_target_usual;

/** In the order of sim_cell_t; ends with NULL. */
extern const char *const sim_cell_words[];

/**
 * Reads `text`.
 *
 * @return false: `self` is undefined, and `reason` holds the number of the line and a sentence
 *
 * @satisfies SWR-BOX-529
 * @satisfies SWR-BOX-530
 */
bool sim_phantom_read(sim_phantom_file_t *self, const char *text, char *reason,
                      uint32_t reason_size);

/**
 * Writes a phantom as such a text, with its end in `size` bytes.
 *
 * @satisfies SWR-BOX-529
 */
void sim_phantom_write(const sim_phantom_file_t *self, char *text, uint32_t size);

#endif
