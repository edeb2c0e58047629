/* SPDX-License-Identifier: Apache-2.0 */
/** @file Which build this is; the build defines BORESIGHT_BUILD as a string ("-DBORESIGHT_BUILD=\"1.0-g12ab\""). */
#ifndef BORESIGHT_BUILD_ID_H
#define BORESIGHT_BUILD_ID_H

#ifdef BORESIGHT_BUILD
#define BUILD_ID BORESIGHT_BUILD
#else
#define BUILD_ID "unnamed"
#endif

#endif
