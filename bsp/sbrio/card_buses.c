/* SPDX-License-Identifier: Apache-2.0 */
#include "sbrio/card_buses.h"

#include "limits/requirement_limits.h"
#include "sbrio/bus_check.h"

#include <stdio.h>
#include <string.h>

/* Above control, which sleeps while a bus begins to transfer. */
#define BUS_PRIORITY 81

static bool has_bus(const card_buses_t *self, uint32_t number)
{
    for (uint32_t i = 0U; i < self->count; i++) {
        if (self->buses[i].number == number) {
            return true;
        }
    }
    return false;
}

/* A bus that is too slow would be late in each cycle. */
static bool is_fast_enough(const wiring_t *wiring, const wiring_spi_t *spi, char *error,
                           uint32_t error_size)
{
    const uint32_t allowed_us = LIMIT_SPI_SHARE_US * wiring->slowness;
    const uint32_t time_us = spi_bus_time_us(wiring, spi->bus);
    const uint32_t clock_hz = spi_bus_clock_needed_hz(wiring, spi->bus, allowed_us);

    if ((time_us > allowed_us) && (clock_hz != 0U)) {
        (void)snprintf(error, error_size,
                       "The cards on the bus of %s take %u us of a cycle, and have %u us; give "
                       "clock=%u or more, or spread them over more buses.",
                       spi->path, (unsigned)time_us, (unsigned)allowed_us, (unsigned)clock_hz);
    } else if (time_us > allowed_us) {
        (void)snprintf(error, error_size,
                       "The cards on the bus of %s take %u us of a cycle, and have %u us; spread "
                       "them over more buses, as no clock is fast enough.",
                       spi->path, (unsigned)time_us, (unsigned)allowed_us);
    } else {
        /* They fit. */
    }
    return time_us <= allowed_us;
}

bool card_buses_open(card_buses_t *self, const wiring_t *wiring, char *error, uint32_t error_size)
{
    self->count = 0U;
    self->begun = (bsp_exchange_t){.started_ns = 0U};
    self->awaited = 0U;
    for (uint32_t i = 0U; i < wiring->spi_count; i++) {
        const wiring_spi_t *const spi = &wiring->spi[i];
        if (has_bus(self, spi->bus)) {
            continue;
        }
        if (!is_fast_enough(wiring, spi, error, error_size) ||
            !spi_bus_open(&self->buses[self->count], wiring, spi->bus, BUS_PRIORITY, error,
                          error_size)) {
            card_buses_close(self);
            return false;
        }
        self->count++;
    }
    return true;
}

static void set_results(card_buses_t *self, uint32_t slots, bsp_slot_result_t result)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((slots & (1U << slot)) != 0U) {
            self->begun.results[slot] = (uint8_t)result;
        }
    }
}

void card_buses_start(card_buses_t *self, uint32_t send,
                      const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES], uint32_t gap_us)
{
    self->awaited = 0U;
    self->begun = (bsp_exchange_t){.started_ns = spi_bus_now_ns()};
    for (uint32_t i = 0U; i < self->count; i++) {
        const uint32_t slots = send & self->buses[i].slots;
        if (slots == 0U) {
            continue;
        }
        if (spi_bus_start(&self->buses[i], slots, frames, gap_us)) {
            set_results(self, slots, BSP_SLOT_LATE);
            self->awaited |= slots;
        } else {
            set_results(self, slots, BSP_SLOT_NOT_IDLE);
        }
    }
}

/* Result of a slot whose exchange has ended. */
static bsp_slot_result_t result_of(const spi_bus_t *bus, uint32_t slot)
{
    if (spi_bus_error(bus, slot) != 0) {
        return BSP_SLOT_BUS_ERROR;
    }
    return bus_check_stands_still(bus->received[slot]) ? BSP_SLOT_NO_ANSWER : BSP_SLOT_OK;
}

static void collect(card_buses_t *self, const spi_bus_t *bus,
                    uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((self->awaited & bus->slots & (1U << slot)) == 0U) {
            continue;
        }
        const bsp_slot_result_t result = result_of(bus, slot);
        self->begun.results[slot] = (uint8_t)result;
        if (result == BSP_SLOT_BUS_ERROR) {
            self->begun.error = spi_bus_error(bus, slot);
        } else if (result == BSP_SLOT_OK) {
            self->begun.received |= 1U << slot;
            self->begun.sampled_ns[slot] = bus->sampled_ns[slot];
            (void)memcpy(received[slot], bus->received[slot], CARD_FRAME_BYTES);
        } else {
            /* No card is there. */
        }
    }
}

void card_buses_finish(card_buses_t *self, uint64_t deadline_ns,
                       uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES], bsp_exchange_t *result)
{
    uint64_t last_ns = 0U;
    for (uint32_t i = 0U; i < self->count; i++) {
        const spi_bus_t *const bus = &self->buses[i];
        const bool has_ended = spi_bus_await(bus, deadline_ns);
        const uint64_t ended_ns = has_ended ? bus->finished_ns : spi_bus_now_ns();
        if (has_ended) {
            collect(self, bus, received);
        }
        last_ns = (ended_ns > last_ns) ? ended_ns : last_ns;
    }
    self->begun.finished_ns = (self->begun.started_ns != 0U) ? last_ns : 0U;
    *result = self->begun;
    self->begun = (bsp_exchange_t){.started_ns = 0U};
    self->awaited = 0U;
}

void card_buses_close(card_buses_t *self)
{
    for (uint32_t i = 0U; i < self->count; i++) {
        spi_bus_close(&self->buses[i]);
    }
    self->count = 0U;
}
