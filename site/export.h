/* SPDX-License-Identifier: Apache-2.0 */
/** @file How a function becomes one that a page may call. */
#ifndef BORESIGHT_EXPORT_H
#define BORESIGHT_EXPORT_H

#ifdef __wasm__
#define EXPORT(name) __attribute__((export_name(#name)))
#else
#define EXPORT(name)
#endif

#endif
