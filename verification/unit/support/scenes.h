/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * How much of a long test is played. The gate unit plays all; where each instruction is emulated or
 * watched (tools/c_tests.rb), every test plays, a long one a tenth of its scenes, of its time or of
 * its way: there the question is what a processor or a sanitizer makes of the code, not what the
 * code decides. What only the whole can show is asked for where ARE_SCENES_WHOLE.
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
