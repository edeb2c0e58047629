/* SPDX-License-Identifier: Apache-2.0 */
/** @file SHA-256 by OpenSSL's names, as far as a recording needs it. */
#ifndef BORESIGHT_SITE_EVP_H
#define BORESIGHT_SITE_EVP_H

#include <stddef.h>

typedef struct evp_md_ctx EVP_MD_CTX;
typedef struct evp_md EVP_MD;

const EVP_MD *EVP_sha256(void);

EVP_MD_CTX *EVP_MD_CTX_new(void);
void EVP_MD_CTX_free(EVP_MD_CTX *context);

/** 1, as all of these: it is done. */
int EVP_DigestInit_ex(EVP_MD_CTX *context, const EVP_MD *kind, void *engine);
int EVP_DigestUpdate(EVP_MD_CTX *context, const void *bytes, size_t size);
int EVP_DigestFinal_ex(EVP_MD_CTX *context, unsigned char *hash, unsigned int *size);

#endif
