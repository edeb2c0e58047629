/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_ports_values.h"

#include <arpa/inet.h>
#include <stdio.h>
#include <string.h>

#define NETWORK_SIZE 32U /* "255.255.255.255/32" and blanks. */
#define ADDRESS_BITS 32U

char *igtl_ports_trim(char *text)
{
    size_t length;

    text += strspn(text, " \t");
    length = strlen(text);
    while ((length > 0U) && ((text[length - 1U] == ' ') || (text[length - 1U] == '\t'))) {
        length--;
    }
    text[length] = '\0';
    return text;
}

bool igtl_ports_is_word(const char *text, size_t most)
{
    const size_t length = strlen(text);

    return (length > 0U) && (length <= most) &&
           (strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") ==
            length);
}

/* Decimal digits without a leading zero, at most `most`. */
static bool read_number(const char *text, uint32_t most, uint32_t *number)
{
    uint32_t value = 0U;

    if ((text[0] == '\0') || ((text[0] == '0') && (text[1] != '\0'))) {
        return false;
    }
    for (const char *at = text; *at != '\0'; at++) {
        if ((*at < '0') || (*at > '9')) {
            return false;
        }
        value = (value * 10U) + (uint32_t)(*at - '0');
        if (value > most) {
            return false;
        }
    }
    *number = value;
    return true;
}

bool igtl_ports_read_address(const char *text, uint32_t *address)
{
    struct in_addr place;

    if (inet_pton(AF_INET, text, &place) != 1) {
        return false;
    }
    *address = ntohl(place.s_addr);
    return true;
}

bool igtl_ports_read_place(const char *text, uint32_t *address, uint16_t *number)
{
    char dotted[NETWORK_SIZE];
    const char *colon = strchr(text, ':');
    uint32_t port = 0U;

    if ((colon == NULL) || ((size_t)(colon - text) >= sizeof dotted)) {
        return false;
    }
    (void)snprintf(dotted, sizeof dotted, "%.*s", (int)(colon - text), text);
    if (!igtl_ports_read_address(dotted, address) || !read_number(&colon[1], UINT16_MAX, &port) ||
        (port == 0U)) {
        return false;
    }
    *number = (uint16_t)port;
    return true;
}

bool igtl_ports_read_dialect(const char *text, igtl_language_t *language)
{
    static const char *const names[] = {[IGTL_LANGUAGE_BRP_2013] = "brp-2013",
                                        [IGTL_LANGUAGE_BRP_2021] = "brp-2021",
                                        [IGTL_LANGUAGE_CRTK] = "crtk"};

    for (uint32_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        if (strcmp(text, names[i]) == 0) {
            *language = (igtl_language_t)i;
            return true;
        }
    }
    return false;
}

bool igtl_ports_read_prefix(const char *text, char prefix[IGTL_PREFIX_SIZE])
{
    static const char *const others[] = {"CMD_", "CLB_", "TGT_", "NPOS_", "ACK_"};

    if (!igtl_ports_is_word(text, IGTL_PREFIX_SIZE - 1U)) {
        return false;
    }
    for (uint32_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        const size_t own = strlen(text);
        const size_t its = strlen(others[i]);

        if (strncmp(text, others[i], (own < its) ? own : its) == 0) {
            return false;
        }
    }
    (void)snprintf(prefix, IGTL_PREFIX_SIZE, "%s", text);
    return true;
}

static bool read_network(char *text, igtl_network_t *network)
{
    char *slash = strchr(text, '/');
    uint32_t bits = ADDRESS_BITS;

    if (slash != NULL) {
        *slash = '\0';
        if (!read_number(&slash[1], ADDRESS_BITS, &bits)) {
            return false;
        }
    }
    network->mask = (bits == 0U) ? 0U : (UINT32_MAX << (ADDRESS_BITS - bits));
    return igtl_ports_read_address(text, &network->address) &&
           ((network->address & ~network->mask) == 0U);
}

bool igtl_ports_read_allowed(const char *text, igtl_port_t *port)
{
    const char *at = text;

    while (port->allowed_count < IGTL_ALLOWED) {
        char one[NETWORK_SIZE];
        const size_t length = strcspn(at, ",");

        if (length >= sizeof one) {
            return false;
        }
        (void)snprintf(one, sizeof one, "%.*s", (int)length, at);
        if (!read_network(igtl_ports_trim(one), &port->allowed[port->allowed_count])) {
            return false;
        }
        port->allowed_count++;
        if (at[length] == '\0') {
            return true;
        }
        at += length + 1U;
    }
    return false;
}
