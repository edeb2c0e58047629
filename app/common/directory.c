/* SPDX-License-Identifier: Apache-2.0 */
#include "common/directory.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#define PATH_SIZE 512U
#define DIRECTORY_MODE 0750

bool directory_make(const char *directory)
{
    char path[PATH_SIZE];

    (void)snprintf(path, sizeof path, "%s", directory);
    for (char *slash = strchr(&path[1], '/'); slash != NULL; slash = strchr(&slash[1], '/')) {
        *slash = '\0';
        (void)mkdir(path, DIRECTORY_MODE);
        *slash = '/';
    }
    return (mkdir(path, DIRECTORY_MODE) == 0) || (errno == EEXIST);
}
