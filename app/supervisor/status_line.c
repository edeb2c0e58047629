/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/status_line.h"

#include "charts/card_link_chart.h"
#include "charts/estop_latch_chart.h"
#include "charts/pedal_gate_chart.h"
#include "exchange/exchange_peers.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "robot/robot_cards.h"
#include "safety/permit.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Appends as much as fits. */
static void add(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void add(char *text, size_t size, const char *format, ...)
{
    const size_t used = strlen(text);
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(&text[used], size - used, format, arguments);
    va_end(arguments);
}

static const char *pedal_word(uint32_t state)
{
    switch (state) {
    case PEDAL_GATE_STATE_UNPROVEN:
        return "unproven";
    case PEDAL_GATE_STATE_RELEASED:
        return "released";
    case PEDAL_GATE_STATE_CLOSING:
        return "closing";
    case PEDAL_GATE_STATE_PRESSED:
        return "pressed";
    case PEDAL_GATE_STATE_OPENING:
        return "opening";
    default:
        return "FAULT";
    }
}

static const char *estop_word(uint32_t state)
{
    switch (state) {
    case ESTOP_LATCH_STATE_CLEAR:
        return "clear";
    case ESTOP_LATCH_STATE_PULLED:
        return "PULLED";
    default:
        return "latched";
    }
}

/* The reason to be told first, of all axes; PERMIT_REASON_COUNT when every axis may be driven. */
static uint32_t first_reason(const snapshot_t *snapshot)
{
    uint32_t reasons = 0U;
    uint32_t reason = 0U;

    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        reasons |= snapshot->axes[i].permit_reasons;
    }
    while ((reason < PERMIT_REASON_COUNT) && ((reasons & (1U << reason)) == 0U)) {
        reason++;
    }
    return reason;
}

static void add_permit(char *text, size_t size, const snapshot_t *snapshot)
{
    const uint32_t reason = first_reason(snapshot);

    if (reason == PERMIT_REASON_COUNT) {
        add(text, size, " | motion permitted");
        return;
    }
    const char *name = permit_reason_name((int32_t)reason);
    add(text, size, " | no motion: ");
    for (size_t i = 0U; name[i] != '\0'; i++) {
        add(text, size, "%c", (name[i] == '_') ? ' ' : tolower((unsigned char)name[i]));
    }
}

/* How many of the cards that the robot names answer. */
static void add_links(char *text, size_t size, const robot_t *robot, const snapshot_t *snapshot)
{
    uint32_t named = 0U;
    uint32_t live = 0U;

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const bool is_named = robot_cards_type(robot, slot) != (uint32_t)CARD_TYPE_NONE;
        const bool is_live = snapshot->cards[slot].link == (uint32_t)CARD_LINK_STATE_LIVE;
        named += is_named ? 1U : 0U;
        live += (is_named && is_live) ? 1U : 0U;
    }
    add(text, size, " | links %u/%u", (unsigned)live, (unsigned)named);
}

/** @satisfies SWR-SUP-005 */
static void add_time(char *text, size_t size, const loop_figures_t *loop, bool is_silent)
{
    const unsigned percent = is_silent ? 0U : ((loop->speed_permille + 5U) / 10U);

    if (loop->is_elastic != 0U) {
        add(text, size, " | elastic time %u %%", percent);
    } else {
        add(text, size, " | real time %u %%, loop p99 %u us, worst %u us", percent,
            (unsigned)loop->wake_p99_us, (unsigned)loop->wake_worst_us);
    }
}

static void add_programs(char *text, size_t size, const exchange_t *exchange, family_t *family)
{
    add(text, size, " |");
    for (uint32_t i = 0U; i < FAMILY_SIZE; i++) {
        const child_t *child = &family->members[i];
        const bool is_silent = family_is_silent(family, exchange, (member_t)i);
        const char *word = "ok";
        if (child->name == NULL) {
            continue;
        }
        if (family->runs_already[i]) {
            word = "not ours";
        } else if (child->pid == 0) {
            word = "RESTARTING";
        } else if (is_silent) {
            word = "SILENT";
        } else {
            /* Runs and beats. */
        }
        add(text, size, " %s %s", child->name, word);
    }
}

/** @satisfies SWR-AUTH-018 */
static void add_authority(char *text, size_t size, const exchange_t *exchange,
                          const snapshot_t *snapshot)
{
    const uint32_t cycles = snapshot->cycle - snapshot->held_since_cycle;
    char title[EXCHANGE_TITLE_SIZE];

    if (snapshot->holder_peer == 0U) {
        add(text, size, " | nobody commands");
    } else {
        exchange_title(exchange, (command_source_t)snapshot->holder, snapshot->holder_peer, title);
        add(text, size, " | commanded by %s for %u s", title,
            (unsigned)(cycles / (1000000U / LIMIT_CYCLE_US)));
    }
    if (snapshot->request_left_us != 0U) {
        exchange_title(exchange, (command_source_t)snapshot->requester, snapshot->requester_peer,
                       title);
        add(text, size, " | %s asks for the button, %u s left", title,
            (unsigned)((snapshot->request_left_us + 999999U) / 1000000U));
    }
}

/* What came from the file of ports and is not there.
 *
 * @satisfies SWR-SUP-010 */
static void add_unreached(char *text, size_t size, const exchange_t *exchange)
{
    exchange_ports_t ports;

    if (!exchange_read_ports(exchange, &ports)) {
        return;
    }
    for (uint32_t i = 0U; i < ports.count; i++) {
        const exchange_port_t *port = &ports.ports[i];
        char place[IGTL_PLACE_SIZE];

        if ((port->state == (uint32_t)EXCHANGE_PORT_CALLING) ||
            (port->state == (uint32_t)EXCHANGE_PORT_WAITING)) {
            igtl_port_place(port->address, (uint16_t)port->number, place);
            add(text, size, " | %s %s not connected", port->name, place);
        }
    }
}

void status_line_write(char *text, size_t size, const exchange_t *exchange, family_t *family)
{
    const robot_t *robot = exchange_robot(exchange);
    snapshot_t snapshot;
    loop_figures_t loop;

    text[0] = '\0';
    if (exchange_read_snapshot(exchange, &snapshot)) {
        add(text, size, "%s | pedal %s | e-stop %s", workphase_name((int32_t)snapshot.workphase),
            pedal_word(snapshot.pedal), estop_word(snapshot.estop));
        add_permit(text, size, &snapshot);
        add_authority(text, size, exchange, &snapshot);
        add_links(text, size, robot, &snapshot);
    } else {
        add(text, size, "starting");
    }
    if (exchange_read_loop(exchange, &loop)) {
        add_time(text, size, &loop, family_is_silent(family, exchange, MEMBER_CONTROL));
    }
    add_programs(text, size, exchange, family);
    add_unreached(text, size, exchange);
}
