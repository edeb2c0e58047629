/* SPDX-License-Identifier: Apache-2.0 */
/** @file SHA-256 (FIPS 180-4, 6.2) where no OpenSSL is. Each recording is hashed by OpenSSL, and so
 * verifies it. */
#include <openssl/evp.h>
#include <stdint.h>
#include <string.h>

#define BLOCK 64U
#define ROUNDS 64U
#define WORDS 8U
#define LENGTH_AT (BLOCK - 8U)

struct evp_md_ctx {
    uint32_t state[WORDS];
    uint64_t bytes;
    uint8_t block[BLOCK];
};

static EVP_MD_CTX only;

static const uint32_t first_state[WORDS] = {0x6A09E667U, 0xBB67AE85U, 0x3C6EF372U, 0xA54FF53AU,
                                            0x510E527FU, 0x9B05688CU, 0x1F83D9ABU, 0x5BE0CD19U};

static const uint32_t constants[ROUNDS] = {
    0x428A2F98U, 0x71374491U, 0xB5C0FBCFU, 0xE9B5DBA5U, 0x3956C25BU, 0x59F111F1U, 0x923F82A4U,
    0xAB1C5ED5U, 0xD807AA98U, 0x12835B01U, 0x243185BEU, 0x550C7DC3U, 0x72BE5D74U, 0x80DEB1FEU,
    0x9BDC06A7U, 0xC19BF174U, 0xE49B69C1U, 0xEFBE4786U, 0x0FC19DC6U, 0x240CA1CCU, 0x2DE92C6FU,
    0x4A7484AAU, 0x5CB0A9DCU, 0x76F988DAU, 0x983E5152U, 0xA831C66DU, 0xB00327C8U, 0xBF597FC7U,
    0xC6E00BF3U, 0xD5A79147U, 0x06CA6351U, 0x14292967U, 0x27B70A85U, 0x2E1B2138U, 0x4D2C6DFCU,
    0x53380D13U, 0x650A7354U, 0x766A0ABBU, 0x81C2C92EU, 0x92722C85U, 0xA2BFE8A1U, 0xA81A664BU,
    0xC24B8B70U, 0xC76C51A3U, 0xD192E819U, 0xD6990624U, 0xF40E3585U, 0x106AA070U, 0x19A4C116U,
    0x1E376C08U, 0x2748774CU, 0x34B0BCB5U, 0x391C0CB3U, 0x4ED8AA4AU, 0x5B9CCA4FU, 0x682E6FF3U,
    0x748F82EEU, 0x78A5636FU, 0x84C87814U, 0x8CC70208U, 0x90BEFFFAU, 0xA4506CEBU, 0xBEF9A3F7U,
    0xC67178F2U};

static uint32_t turn(uint32_t word, uint32_t bits)
{
    return (word >> bits) | (word << (32U - bits));
}

static void schedule(const uint8_t block[BLOCK], uint32_t words[ROUNDS])
{
    for (uint32_t i = 0U; i < 16U; i++) {
        const uint8_t *const at = &block[4U * i];
        words[i] = ((uint32_t)at[0] << 24U) | ((uint32_t)at[1] << 16U) | ((uint32_t)at[2] << 8U) |
                   (uint32_t)at[3];
    }
    for (uint32_t i = 16U; i < ROUNDS; i++) {
        const uint32_t early = words[i - 15U];
        const uint32_t late = words[i - 2U];
        words[i] = words[i - 16U] + (turn(early, 7U) ^ turn(early, 18U) ^ (early >> 3U)) +
                   words[i - 7U] + (turn(late, 17U) ^ turn(late, 19U) ^ (late >> 10U));
    }
}

static void take_block(EVP_MD_CTX *self)
{
    uint32_t words[ROUNDS];
    uint32_t s[WORDS]; /* a to h of the standard. */

    schedule(self->block, words);
    (void)memcpy(s, self->state, sizeof s);
    for (uint32_t i = 0U; i < ROUNDS; i++) {
        const uint32_t one = s[7] + (turn(s[4], 6U) ^ turn(s[4], 11U) ^ turn(s[4], 25U)) +
                             ((s[4] & s[5]) ^ (~s[4] & s[6])) + constants[i] + words[i];
        const uint32_t two = (turn(s[0], 2U) ^ turn(s[0], 13U) ^ turn(s[0], 22U)) +
                             ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
        (void)memmove(&s[1], &s[0], (WORDS - 1U) * sizeof s[0]);
        s[4] += one;
        s[0] = one + two;
    }
    for (uint32_t i = 0U; i < WORDS; i++) {
        self->state[i] += s[i];
    }
}

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
    (void)memcpy(context->state, first_state, sizeof first_state);
    context->bytes = 0U;
    return 1;
}

int EVP_DigestUpdate(EVP_MD_CTX *context, const void *bytes, size_t size)
{
    const uint8_t *at = bytes;
    size_t left = size;

    while (left > 0U) {
        const size_t used = (size_t)(context->bytes % BLOCK);
        const size_t count = (left < (BLOCK - used)) ? left : (BLOCK - used);
        (void)memcpy(&context->block[used], at, count);
        context->bytes += count;
        at = &at[count];
        left -= count;
        if ((used + count) == BLOCK) {
            take_block(context);
        }
    }
    return 1;
}

int EVP_DigestFinal_ex(EVP_MD_CTX *context, unsigned char *hash, unsigned int *size)
{
    static const uint8_t end[BLOCK] = {0x80U};
    const uint64_t bits = 8U * context->bytes;
    const size_t used = (size_t)(context->bytes % BLOCK);
    uint8_t length[8];

    (void)size;
    for (uint32_t i = 0U; i < sizeof length; i++) {
        length[i] = (uint8_t)(bits >> (56U - (8U * i)));
    }
    (void)EVP_DigestUpdate(context, end,
                           (used < LENGTH_AT) ? (LENGTH_AT - used) : (BLOCK + LENGTH_AT - used));
    (void)EVP_DigestUpdate(context, length, sizeof length);
    for (uint32_t i = 0U; i < (4U * WORDS); i++) {
        hash[i] = (uint8_t)(context->state[i / 4U] >> (24U - (8U * (i % 4U))));
    }
    return 1;
}
