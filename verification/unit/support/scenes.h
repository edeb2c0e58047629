/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * How many of the scenes of a long test are played. The code under test as it is delivered plays
 * all of them; where each instruction is emulated or watched (tools/c_tests.rb), one of three:
 * there the question is what a processor or a sanitizer makes of the code, not what the code
 * decides.
 */
#ifndef BORESIGHT_SCENES_H
#define BORESIGHT_SCENES_H

#ifndef SCENE_DIVISOR
#define SCENE_DIVISOR 1U
#endif

#define SCENES(count) (((count) + (SCENE_DIVISOR - 1U)) / SCENE_DIVISOR)

#endif
