/* SPDX-License-Identifier: Apache-2.0 */
#include "exchange/exchange_files.h"

#include "exchange/exchange_segment.h"

void exchange_note_file(exchange_t *self, exchange_file_t file, uint32_t number)
{
    __atomic_store_n(&self->segment->others.files[file], number, __ATOMIC_RELEASE);
}

uint32_t exchange_file(const exchange_t *self, exchange_file_t file)
{
    return __atomic_load_n(&self->segment->others.files[file], __ATOMIC_ACQUIRE);
}
