/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The mark of a browser that has logged in before, after the device cookies of OWASP: an
 * HMAC-SHA-256 over the account's name, with a key that only this process has. Failed logins of
 * browsers with the mark of a name are counted apart from those of other browsers.
 */
#ifndef BORESIGHT_DEVICE_MARK_H
#define BORESIGHT_DEVICE_MARK_H

#include <stdbool.h>
#include <stdint.h>

#define DEVICE_KEY_SIZE 32U
#define DEVICE_MARK_SIZE 65U /**< In hexadecimal, with a NUL. */

/** All zero: no mark is made, and none fits. */
typedef struct {
    bool is_made;
    uint8_t bytes[DEVICE_KEY_SIZE];
} device_key_t;

/** Makes a key of random bytes; without any it stays all zero. */
void device_key_make(device_key_t *self);

/** Writes the mark of `name`. False: there is no key, or the library is out of memory. */
bool device_mark_make(const device_key_t *key, const char *name, char mark[DEVICE_MARK_SIZE]);

/** Whether `mark` is that of `name`. NULL is none. */
bool device_mark_fits(const device_key_t *key, const char *name, const char *mark);

#endif
