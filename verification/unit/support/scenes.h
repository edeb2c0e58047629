/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * How much of a long test is played. The gate scenes plays all, on the product's code. Where each
 * instruction is counted, emulated or watched (the gates unit and arm), every test plays,
 * a long one a tenth of its scenes, of its time or of its way: there the question is which code is
 * reached and what a processor or a sanitizer makes of it, not what the code decides. Facts that
 * only the whole can show are asked for where ARE_SCENES_WHOLE.
 */
#ifndef BORESIGHT_SCENES_H
#define BORESIGHT_SCENES_H

#ifndef SCENE_DIVISOR
#define SCENE_DIVISOR 1U
#endif

#define ARE_SCENES_WHOLE (SCENE_DIVISOR == 1U)
/** How many of `count`, at least one. */
#define SCENES(count) (((count) + (SCENE_DIVISOR - 1U)) / SCENE_DIVISOR)

#endif
