/* SPDX-License-Identifier: Apache-2.0 */
/** @file Which build this is; make defines BORESIGHT_BUILD_ID. */
#ifndef BORESIGHT_BUILD_ID_H
#define BORESIGHT_BUILD_ID_H

#ifdef BORESIGHT_BUILD_ID
#define BUILD_ID BORESIGHT_BUILD_ID
#else
#define BUILD_ID "development"
#endif

#endif
