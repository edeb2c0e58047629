/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Measures on the simulated control box, in simulated time, how soon the controller finds a fault
 * of an encoder or a motor of an axis that runs at its speed, and how far it has gone astray until
 * it rests. Writes docs/detection.md.
 *
 *     detection
 */
#include "integration/support/rig.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Blind: nothing or the opposite is counted. Wrong: something is, but not what the motor makes. */
typedef struct {
    const char *part;
    const char *fault;
    const char *says;
    bool is_blind;
} fault_t;

typedef struct {
    const char *found;
    uint32_t cycles;
    double moved; /* True way from the fault to rest, in mm or degrees. */
    double apart; /* How much farther true and believed position are apart then. */
} figures_t;

static const fault_t faults[] = {{"encoder", "stuck", "encoder cut or stuck", true},
                                 {"encoder", "reversed", "encoder lines swapped", true},
                                 {"motor", "stuck", "shaft blocked", true},
                                 {"encoder", "half", "half the counts", false},
                                 {"motor", "half", "motor half as fast", false},
                                 {"motor", "twice", "motor twice as fast", false}};

static const struct {
    event_id_t id;
    const char *says;
} events[] = {{EVENT_AXIS_WRONG_WAY, "wrong way"},
              {EVENT_AXIS_NO_COUNTS, "no counts"},
              {EVENT_AXIS_WRONG_SPEED, "wrong speed"},
              {EVENT_AXIS_UNEVEN_COUNTS, "uneven counts"},
              {EVENT_AXIS_FOLLOWING_ERROR, "following error"},
              {EVENT_AXIS_STALLED, "stall"}};

/* Aims: ms, then mm and degrees. */
#define BLIND_MS 30U
#define WRONG_MS 150U
static const double blind_ways[] = {0.3, 2.5};
static const double wrong_ways[] = {0.8, 9.0};

#define LONGEST_CYCLES 2000U
#define REST_CYCLES 200U
#define SCAN_CYCLES 600000U

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
}

void contract_broken(const char *module, uint32_t id)
{
    printf("contract %s/%u is broken\n", module, (unsigned)id);
    exit(2);
}

static const axis_config_t *config_of(uint32_t axis)
{
    return &robot_neuro.axes[axis];
}

/* Ticks in mm or degrees. */
static double measure(uint32_t axis, double ticks)
{
    const double units = fabs(ticks) * (double)config_of(axis)->unit_per_tick_q16 / 65536.0;
    return (config_of(axis)->unit == (uint8_t)AXIS_UNIT_MM) ? (units / 1e6)
                                                            : (units * 360.0 / 4294967296.0);
}

static const char *unit_of(uint32_t axis)
{
    return (config_of(axis)->unit == (uint8_t)AXIS_UNIT_MM) ? "mm" : "deg";
}

static double truth(uint32_t axis)
{
    return rig.box.axes[axis].motor.position_ticks;
}

static double belief(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].position_ticks;
}

/* `axis` is jogged and has run at its speed for a while. */
static void cruise(uint32_t axis)
{
    static const int32_t ends[ROBOT_AXIS_MAX] = {-5000, 4000, -2000, 60000, 5000, -300, -1100};
    const command_t jog = {.kind = COMMAND_JOG, .as.jog = {.axis = axis, .to_ticks = ends[axis]}};
    const int32_t almost_percent = (int32_t)LIMIT_PROFILE_SPEED_PERCENT - 1;
    const int32_t speed_q8 = config_of(axis)->speed_ticks_per_s * 256 / 100 * almost_percent;
    const snapshot_axis_t *const shown = &rig.outputs.snapshot.axes[axis];
    rig_start_robot_homed(&rig, &robot_neuro);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    (void)rig_command(&rig, jog);
    rig_press(&rig);
    while ((shown->setpoint_speed_ticks_per_s_q8 < speed_q8) &&
           (shown->setpoint_speed_ticks_per_s_q8 > -speed_q8)) {
        rig_cycle(&rig);
    }
    rig_cycles(&rig, 100U);
    rig_forget(&rig);
}

static const char *noticed(void)
{
    for (uint32_t i = 0U; i < (sizeof events / sizeof events[0]); i++) {
        if (rig_count(&rig, events[i].id) != 0U) {
            return events[i].says;
        }
    }
    return NULL;
}

static figures_t find(uint32_t axis, const fault_t *fault)
{
    figures_t figures = {.found = NULL};
    char order[48];
    cruise(axis);
    const double start = truth(axis);
    const double apart = truth(axis) - belief(axis);
    (void)snprintf(order, sizeof order, "%s %s %s", fault->part, config_of(axis)->name,
                   fault->fault);
    rig_box(&rig, order);
    while ((figures.found == NULL) && (figures.cycles < LONGEST_CYCLES)) {
        rig_cycle(&rig);
        figures.cycles++;
        figures.found = noticed();
    }
    rig_cycles(&rig, REST_CYCLES);
    figures.moved = measure(axis, truth(axis) - start);
    figures.apart = measure(axis, truth(axis) - belief(axis) - apart);
    return figures;
}

static bool is_met(uint32_t axis, const fault_t *fault, const figures_t *figures)
{
    const uint8_t unit = config_of(axis)->unit;
    return fault->is_blind
               ? ((figures->cycles <= BLIND_MS + 10U) && (figures->moved <= blind_ways[unit]))
               : ((figures->cycles <= WRONG_MS) && (figures->apart <= wrong_ways[unit]));
}

static void print_row(uint32_t axis, const fault_t *fault)
{
    const figures_t figures = find(axis, fault);
    const int digits = (config_of(axis)->unit == (uint8_t)AXIS_UNIT_MM) ? 2 : 1;
    const char *const unit = unit_of(axis);
    printf("| %s | %s | %u ms | %.*f %s | %.*f %s | %s | %s |\n", fault->says,
           config_of(axis)->name, (unsigned)figures.cycles, digits, figures.moved, unit, digits,
           figures.apart, unit, (figures.found == NULL) ? "nothing" : figures.found,
           is_met(axis, fault, &figures) ? "yes" : "**no**");
}

/* Wrong counts that a scanner leaves behind: the account at the end against the truth. */
static void print_scan(void)
{
    double before[ROBOT_AXIS_MAX];
    uint32_t criticals = 0U;
    rig_start_robot_homed(&rig, &robot_neuro);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        before[i] = truth(i) - belief(i);
    }
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, SCAN_CYCLES);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, REST_CYCLES);
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        const event_t *const event = &rig.events[i];
        criticals += (event->severity == (uint32_t)EVENT_SEVERITY_CRITICAL) ? 1U : 0U;
        if (event->id == (uint32_t)EVENT_SCAN_DRIFT) {
            const uint32_t axis = event->subject;
            const double apart = belief(axis) - truth(axis) + before[axis];
            printf("| %s | %d ticks | %.1f ticks | %.3f %s | %s |\n", config_of(axis)->name,
                   (int)event->value, apart, measure(axis, apart), unit_of(axis),
                   axis_is_homed(&rig.controller.axes[axis]) ? "yes" : "no");
        }
    }
    printf("\nCritical events: %u.\n", (unsigned)criticals);
}

int main(void)
{
    UnityBegin("detection.c");
    (void)puts("# How soon a blind axis is found\n\n"
               "Measured on the simulated control box by `make detection`; the gate `supervise` "
               "measures it again.\nEach axis runs at its speed when the fault comes. Moved is the "
               "true way from there to rest, apart how much\nfarther the true and the believed "
               "position are apart then.\n\nAim: nothing or the opposite counted, 30 ms from when "
               "4 counts are due (here 40 ms from the fault) and 0.3 mm or\n2.5 degrees of motion; "
               "wrong counts or a wrong speed, 150 ms and 0.8 mm or 9 degrees apart.\n\n"
               "| Fault | Axis | Found after | Moved | Apart | By | Aim met |\n"
               "| --- | --- | --- | --- | --- | --- | --- |");
    for (uint32_t i = 0U; i < (sizeof faults / sizeof faults[0]); i++) {
        for (uint32_t axis = 0U; axis < robot_neuro.axis_count; axis++) {
            print_row(axis, &faults[i]);
        }
    }
    (void)puts(
        "\n## Ten minutes of scanning\n\n"
        "The counts of each axis at rest are added up. Beyond 0.1 mm or 0.5 degrees since its "
        "last reference it is not homed any\nmore: START_UP homes it, or the operator "
        "confirms it.\n\n"
        "| Axis | Added up in the scan | Truly apart | That is | Still homed |\n"
        "| --- | --- | --- | --- | --- |");
    print_scan();
    return 0;
}
