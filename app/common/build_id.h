/* SPDX-License-Identifier: Apache-2.0 */
/** @file Which version and build this is; make defines BORESIGHT_VERSION and BORESIGHT_BUILD_ID. */
#ifndef BORESIGHT_BUILD_ID_H
#define BORESIGHT_BUILD_ID_H

/** The newest one of CHANGELOG.md: "1.2.0", or "unreleased" for what follows it. */
#ifdef BORESIGHT_VERSION
#define BUILD_VERSION BORESIGHT_VERSION
#else
#define BUILD_VERSION "development"
#endif

/** The commit, with a "+" if something was changed since. */
#ifdef BORESIGHT_BUILD_ID
#define BUILD_ID BORESIGHT_BUILD_ID
#else
#define BUILD_ID "development"
#endif

#endif
