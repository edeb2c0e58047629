/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Functions that a static program lacks without the C library that it was built beside: loading
 * libraries, and looking up hosts and users. The libraries in it could ask for that, but Boresight
 * never makes them do so. The linker puts these in the place of the functions that they are named
 * after.
 *
 * @satisfies SWR-ARM-002
 */
#include <netdb.h>
#include <pwd.h>
#include <stddef.h>

void *__wrap_dlopen(const char *file, int mode);
int __wrap_getaddrinfo(const char *node, const char *service, const struct addrinfo *hints,
                       struct addrinfo **found);
struct hostent *__wrap_gethostbyname(const char *name);
struct passwd *__wrap_getpwnam(const char *name);

void *__wrap_dlopen(const char *file, int mode)
{
    (void)file;
    (void)mode;
    return NULL;
}

int __wrap_getaddrinfo(const char *node, const char *service, const struct addrinfo *hints,
                       struct addrinfo **found)
{
    (void)node;
    (void)service;
    (void)hints;
    *found = NULL;
    return EAI_FAIL;
}

struct hostent *__wrap_gethostbyname(const char *name)
{
    (void)name;
    return NULL;
}

struct passwd *__wrap_getpwnam(const char *name)
{
    (void)name;
    return NULL;
}
