#ifndef BORESIGHT_EVA_COMPILER_H
#define BORESIGHT_EVA_COMPILER_H
#include <stddef.h>
static inline void *__builtin_assume_aligned(void *address, size_t alignment)
{
    return address;
}
#endif
