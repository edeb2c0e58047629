/* SPDX-License-Identifier: Apache-2.0 */
/** @file Where no OpenSSL is, SHA-256 is libmd's. Each recording is hashed by OpenSSL, and so
 * verifies it. */
#include <openssl/evp.h>
#include <sha2.h>
#include <string.h>

struct evp_md_ctx {
    SHA2_CTX sha2;
};

static EVP_MD_CTX only;

const EVP_MD *EVP_sha256(void)
{
    return NULL;
}

EVP_MD_CTX *EVP_MD_CTX_new(void)
{
    return &only;
}

void EVP_MD_CTX_free(EVP_MD_CTX *context)
{
    (void)context;
}

int EVP_DigestInit_ex(EVP_MD_CTX *context, const EVP_MD *kind, void *engine)
{
    (void)kind;
    (void)engine;
    SHA256Init(&context->sha2);
    return 1;
}

int EVP_DigestUpdate(EVP_MD_CTX *context, const void *bytes, size_t size)
{
    SHA256Update(&context->sha2, bytes, size);
    return 1;
}

int EVP_DigestFinal_ex(EVP_MD_CTX *context, unsigned char *hash, unsigned int *size)
{
    (void)size;
    SHA256Final(hash, &context->sha2);
    return 1;
}
