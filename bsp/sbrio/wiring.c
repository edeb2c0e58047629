/* SPDX-License-Identifier: Apache-2.0 */
#include "sbrio/wiring.h"

#include "limits/requirement_limits.h"
#include "sbrio/wiring_text.h"

#include <stdio.h>
#include <string.h>

#define WATCHDOG_S 5U
#define MOST_GAP_US 100U
#define MOST_CLOCK_HZ 100000000U
/* So slow that real cards would trip between two cycles. */
#define LEAST_SLOWNESS (LIMIT_CARD_WATCHDOG_US / LIMIT_CYCLE_US)
#define SETTINGS 4U

static const char *const line_names[WIRING_LINES] = {
    [WIRING_PEDAL_A] = "pedal_a",       [WIRING_PEDAL_B] = "pedal_b",
    [WIRING_ESTOP] = "estop",           [WIRING_SCANNER] = "scanner",
    [WIRING_CONFIRM] = "confirm",       [WIRING_DOSE] = "dose",
    [WIRING_TREATMENT] = "treatment",   [WIRING_POWER] = "power",
    [WIRING_LAMPS] = "lamp_alive",      [WIRING_LAMPS + 1] = "lamp_may_move",
    [WIRING_LAMPS + 2] = "lamp_moving", [WIRING_LAMPS + 3] = "lamp_fault"};

static const wiring_line_name_t needed_lines[] = {WIRING_PEDAL_A, WIRING_PEDAL_B, WIRING_ESTOP,
                                                  WIRING_SCANNER, WIRING_POWER};

static const char *const setting_names[SETTINGS] = {"slots", "clock", "mode", "gap"};

/* "3" or "0-9". */
static bool read_slots(char *text, wiring_spi_t *spi)
{
    uint32_t last = 0U;
    char *const dash = strchr(text, '-');

    if (dash != NULL) {
        *dash = '\0';
    }
    if (!wiring_number(text, 0U, CARD_SLOT_COUNT - 1U, &spi->first_slot) ||
        !wiring_number((dash != NULL) ? (dash + 1) : text, spi->first_slot, CARD_SLOT_COUNT - 1U,
                       &last)) {
        return false;
    }
    spi->slot_count = last - spi->first_slot + 1U;
    return true;
}

static bool take_spi_setting(const wiring_reader_t *reader, wiring_spi_t *spi, const char *name,
                             char *value)
{
    if (strcmp(name, "slots") == 0) {
        return read_slots(value, spi) ||
               wiring_refuse(reader, name, "needs a slot or a range of them, such as 3 or 0-9");
    }
    if (strcmp(name, "clock") == 0) {
        return wiring_number(value, 1U, MOST_CLOCK_HZ, &spi->clock_hz) ||
               wiring_refuse(reader, name, "needs a clock in Hz, 1 to 100000000");
    }
    if (strcmp(name, "mode") == 0) {
        return wiring_number(value, 0U, 3U, &spi->mode) ||
               wiring_refuse(reader, name, "needs 0, 1, 2 or 3");
    }
    if (strcmp(name, "gap") == 0) {
        return wiring_number(value, 1U, MOST_GAP_US, &spi->gap_us) ||
               wiring_refuse(reader, name, "needs a time in us, 1 to 100");
    }
    return wiring_refuse(reader, name, "is unknown here; expected slots, clock, mode or gap");
}

/* Notes in `said`, a bit for each, that this setting was said. */
static bool is_first(const wiring_reader_t *reader, const char *name, uint32_t *said)
{
    for (uint32_t i = 0U; i < SETTINGS; i++) {
        if (strcmp(name, setting_names[i]) == 0) {
            if (((*said >> i) & 1U) != 0U) {
                return wiring_refuse(reader, name, "is said twice");
            }
            *said |= 1U << i;
        }
    }
    return true;
}

static uint32_t slots_of(const wiring_spi_t *spi)
{
    return ((1U << spi->slot_count) - 1U) << spi->first_slot;
}

/* The description of the device is whole, and no slot is behind two. */
static bool check_spi(const wiring_reader_t *reader, const wiring_t *wiring,
                      const wiring_spi_t *spi)
{
    if ((spi->slot_count == 0U) || (spi->clock_hz == 0U)) {
        return wiring_refuse(reader, spi->path, "needs slots=... and clock=...");
    }
    for (uint32_t i = 0U; i < wiring->spi_count; i++) {
        if ((slots_of(&wiring->spi[i]) & slots_of(spi)) != 0U) {
            return wiring_refuse(reader, spi->path, "has a slot that another device has, too");
        }
    }
    return true;
}

/* The number after the last "spidev" of a path; without one the device is a bus of its own. */
static uint32_t bus_of(const char *path, uint32_t own)
{
    const char *const name = strrchr(path, '/') + 1;
    unsigned bus = 0U;

    return (sscanf(name, "spidev%3u.", &bus) == 1) ? bus : (1000U + own);
}

static bool take_spi(const wiring_reader_t *reader, wiring_t *wiring, const char *device,
                     char *settings)
{
    wiring_spi_t spi = {.clock_hz = 0U};
    uint32_t said = 0U;

    if (!wiring_path(reader, device, spi.path)) {
        return false;
    }
    while (settings != NULL) {
        char *value = wiring_cut(&settings, ",");
        const char *const name = wiring_cut(&value, "=");
        if (value == NULL) {
            return wiring_refuse(reader, name, "lacks its \"=\" and a value");
        }
        if (!is_first(reader, name, &said) ||
            !take_spi_setting(reader, &spi, name, wiring_cut(&value, ""))) {
            return false;
        }
    }
    spi.bus = bus_of(spi.path, wiring->spi_count);
    if (!check_spi(reader, wiring, &spi)) {
        return false;
    }
    wiring->spi[wiring->spi_count] = spi;
    wiring->spi_count++;
    return true;
}

static bool take_line(const wiring_reader_t *reader, wiring_t *wiring, const char *name,
                      const char *value)
{
    uint32_t place = 0U;
    wiring_line_t line = {
        .is_there = true, .chip = wiring->chip_count, .is_active_low = *value == '!'};

    while ((place < (uint32_t)WIRING_LINES) && (strcmp(name, line_names[place]) != 0)) {
        place++;
    }
    if (place == (uint32_t)WIRING_LINES) {
        return wiring_refuse(reader, name, "is no line of a box");
    }
    if (wiring->lines[place].is_there) {
        return wiring_refuse(reader, name, "is said twice");
    }
    if (!wiring_number(line.is_active_low ? (value + 1) : value, 0U, 1023U, &line.offset)) {
        return wiring_refuse(
            reader, name, "needs the number of a line, such as 4, or !4 for a contact to ground");
    }
    if (line.is_active_low && (place == (uint32_t)WIRING_POWER)) {
        return wiring_refuse(reader, name,
                             "cannot be active low: a cut wire must take the power of the drives");
    }
    for (uint32_t i = 0U; i < (uint32_t)WIRING_LINES; i++) {
        const wiring_line_t *const other = &wiring->lines[i];
        if (other->is_there && (other->chip == line.chip) && (other->offset == line.offset)) {
            return wiring_refuse(reader, name, "has the line that another one has");
        }
    }
    wiring->lines[place] = line;
    return true;
}

static bool take_gpio(const wiring_reader_t *reader, wiring_t *wiring, const char *device,
                      char *settings)
{
    const uint32_t chip = wiring->chip_count;

    if (chip == WIRING_CHIPS) {
        return wiring_refuse(reader, device, "is one chip too many; 4 are possible");
    }
    for (uint32_t i = 0U; i < chip; i++) {
        if (strcmp(device, wiring->chips[i]) == 0) {
            return wiring_refuse(reader, device, "is said twice; give all its lines at once");
        }
    }
    if (!wiring_path(reader, device, wiring->chips[chip])) {
        return false;
    }
    while (settings != NULL) {
        char *value = wiring_cut(&settings, ",");
        const char *const name = wiring_cut(&value, "=");
        if ((value == NULL) && (strcmp(name, "pull") == 0)) {
            wiring->are_pulled[chip] = true;
        } else if (value == NULL) {
            return wiring_refuse(reader, name, "lacks its \"=\" and a line");
        } else if (!take_line(reader, wiring, name, wiring_cut(&value, ""))) {
            return false;
        } else {
            /* It is taken. */
        }
    }
    wiring->chip_count++;
    return true;
}

static bool take_watchdog(const wiring_reader_t *reader, wiring_t *wiring, const char *device,
                          char *settings)
{
    if (wiring->watchdog[0] != '\0') {
        return wiring_refuse(reader, "watchdog", "is said twice");
    }
    wiring->watchdog_s = WATCHDOG_S;
    if (!wiring_path(reader, device, wiring->watchdog)) {
        return false;
    }
    if (settings == NULL) {
        return true;
    }
    const char *const name = wiring_cut(&settings, "=");
    if ((strcmp(name, "timeout") != 0) || (settings == NULL) ||
        !wiring_number(wiring_cut(&settings, ""), 1U, 60U, &wiring->watchdog_s)) {
        return wiring_refuse(reader, name,
                             "is unknown here; expected timeout=1 to timeout=60, in s");
    }
    return true;
}

/* A little slower, the cards of a real box would let it drive, late. */
static bool take_slowness(const wiring_reader_t *reader, wiring_t *wiring, const char *text)
{
    if (wiring->slowness != 0U) {
        return wiring_refuse(reader, "slow", "is said twice");
    }
    return (wiring_number(text, 1U, LIMIT_BOX_SLOWEST, &wiring->slowness) &&
            ((wiring->slowness == 1U) || (wiring->slowness >= LEAST_SLOWNESS))) ||
           wiring_refuse(reader, text, "is no slowness; expected 1, or 10 to 100");
}

static bool take_statement(const wiring_reader_t *reader, wiring_t *wiring, char *text)
{
    char *rest = text;
    const char *const keyword = wiring_cut(&rest, ":");

    if (rest == NULL) {
        return wiring_refuse(reader, keyword,
                             "is no statement; expected spidev: ..., gpio: ... or watchdog: ...");
    }
    const char *const device = wiring_cut(&rest, ",");
    if (strcmp(keyword, "spidev") == 0) {
        return take_spi(reader, wiring, device, rest);
    }
    if (strcmp(keyword, "gpio") == 0) {
        return take_gpio(reader, wiring, device, rest);
    }
    if (strcmp(keyword, "watchdog") == 0) {
        return take_watchdog(reader, wiring, device, rest);
    }
    if (strcmp(keyword, "slow") == 0) {
        return take_slowness(reader, wiring, device);
    }
    return wiring_refuse(reader, keyword, "is unknown; expected spidev, gpio, watchdog or slow");
}

/* Statements end with a line or a semicolon; what follows # is a remark. */
static bool take_text(wiring_reader_t *reader, wiring_t *wiring)
{
    while (reader->rest != NULL) {
        char *line = wiring_cut(&reader->rest, "\n");
        reader->line++;
        line[strcspn(line, "#")] = '\0';
        while (line != NULL) {
            char *const statement = wiring_cut(&line, ";");
            if ((*statement != '\0') && !take_statement(reader, wiring, statement)) {
                return false;
            }
        }
    }
    return true;
}

static bool is_whole(const wiring_t *wiring, char *error, uint32_t error_size)
{
    if (wiring->spi_count == 0U) {
        (void)snprintf(error, error_size, "The wiring has no card; add \"spidev: ...\".");
        return false;
    }
    for (uint32_t i = 0U; i < (sizeof needed_lines / sizeof needed_lines[0]); i++) {
        if (!wiring->lines[needed_lines[i]].is_there) {
            (void)snprintf(error, error_size,
                           "The wiring lacks the line \"%s\"; add it to \"gpio: ...\".",
                           line_names[needed_lines[i]]);
            return false;
        }
    }
    return true;
}

bool wiring_read(wiring_t *wiring, const char *address, char *error, uint32_t error_size)
{
    char text[WIRING_TEXT_SIZE];
    wiring_reader_t reader = {.rest = text, .error = error, .error_size = error_size};

    *wiring = (wiring_t){.slowness = 0U};
    if (address[0] == '/') {
        if (!wiring_load(address, text, error, error_size)) {
            return false;
        }
    } else if (snprintf(text, sizeof text, "%s", address) >= (int)sizeof text) {
        (void)snprintf(error, error_size, "The wiring is too long; write it into a file.");
        return false;
    } else {
        /* It is in the address. */
    }
    const bool is_taken = take_text(&reader, wiring) && is_whole(wiring, error, error_size);
    wiring->slowness = (wiring->slowness == 0U) ? 1U : wiring->slowness;
    return is_taken;
}
