/* SPDX-License-Identifier: Apache-2.0 */
#include "sbrio/wire_test.h"

#include "sbrio/bus_check.h"

#include <stdio.h>
#include <string.h>

#define NS_PER_MS UINT64_C(1000000)
#define TIMEOUT_MS 50U
#define APART_US 100U
#define TOGETHER 5U /* Exchanges. */

/* Answers in one exchange, as bus_check.h judges them. */
typedef struct {
    bus_check_seen_t seen[CARD_SLOT_COUNT];
} look_t;

/* No card obeys them: their sequence continues none, and they clear no fault. */
static void write_frames(uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const card_command_t off = {.slot = slot, .axis_id = CARD_NO_AXIS};
        card_frame_encode_command(&off, frames[slot]);
    }
}

static bool is_whole(const wiring_spi_t *spi, const bsp_exchange_t *result, uint32_t slot,
                     char *error, uint32_t error_size)
{
    const uint8_t said = result->results[slot];

    if (said == (uint8_t)BSP_SLOT_BUS_ERROR) {
        (void)snprintf(error, error_size,
                       "%s does not transfer (%s); check its controller's driver.", spi->path,
                       strerror(result->error));
        return false;
    }
    if ((said != (uint8_t)BSP_SLOT_OK) && (said != (uint8_t)BSP_SLOT_NO_ANSWER)) {
        (void)snprintf(error, error_size,
                       "%s does not end a transfer in %u ms; check its controller's driver.",
                       spi->path, TIMEOUT_MS);
        return false;
    }
    return true;
}

/* One exchange over all devices, looked at. */
static bool look(card_buses_t *buses, const wiring_t *wiring, uint32_t gap_us, look_t *looked,
                 char *error, uint32_t error_size)
{
    uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    bsp_exchange_t result;

    (void)memset(received, 0, sizeof received);
    write_frames(frames);
    card_buses_start(buses, CARD_EVERY_SLOT, (const uint8_t(*)[CARD_FRAME_BYTES])frames, gap_us);
    card_buses_finish(buses, spi_bus_now_ns() + (TIMEOUT_MS * NS_PER_MS * wiring->slowness),
                      received, &result);
    for (uint32_t i = 0U; i < wiring->spi_count; i++) {
        const wiring_spi_t *const spi = &wiring->spi[i];
        for (uint32_t slot = spi->first_slot; slot < (spi->first_slot + spi->slot_count); slot++) {
            if (!is_whole(spi, &result, slot, error, error_size)) {
                return false;
            }
            looked->seen[slot] = bus_check_look(slot, received[slot]);
        }
    }
    return true;
}

/* Every slot of every device, and at least one of them alive. */
static bool judge(const wiring_t *wiring, const look_t apart[2], const look_t *together,
                  char *error, uint32_t error_size)
{
    bool is_any_alive = false;
    for (uint32_t i = 0U; i < wiring->spi_count; i++) {
        const wiring_spi_t *const spi = &wiring->spi[i];
        for (uint32_t slot = spi->first_slot; slot < (spi->first_slot + spi->slot_count); slot++) {
            if (!bus_check_judge(spi, slot, &apart[0].seen[slot], &apart[1].seen[slot],
                                 &together->seen[slot], error, error_size)) {
                return false;
            }
            is_any_alive = is_any_alive || (together->seen[slot].answer == BUS_CHECK_ALIVE);
        }
    }
    if (!is_any_alive) {
        (void)snprintf(error, error_size,
                       "No card answers; switch the box on, and check the plugs of its SPI wires.");
    }
    return is_any_alive;
}

bool wire_test_run(card_buses_t *buses, const wiring_t *wiring, char *error, uint32_t error_size)
{
    look_t apart[2];
    look_t together;

    if (!look(buses, wiring, APART_US, &apart[0], error, error_size) ||
        !look(buses, wiring, APART_US, &apart[1], error, error_size)) {
        return false;
    }
    for (uint32_t i = 0U; i < TOGETHER; i++) {
        if (!look(buses, wiring, 0U, &together, error, error_size) ||
            !judge(wiring, apart, &together, error, error_size)) {
            return false;
        }
    }
    return true;
}
