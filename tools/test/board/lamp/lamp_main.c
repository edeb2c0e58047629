/* SPDX-License-Identifier: Apache-2.0 */
/** @file boresight-lamp: prints its arguments, is on, and waits for its end. */
#include <stdio.h>
#include <unistd.h>

int main(int count, char *arguments[])
{
    (void)fputs("lamp:", stderr);
    for (int i = 1; i < count; i++) {
        (void)fprintf(stderr, " %s", arguments[i]);
    }
    (void)fputs("\n", stderr);
    (void)puts("lamp: on");
    (void)fflush(stdout);
    (void)pause();
    return 0;
}
