/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/box.h"

#include "robot/robot_cards.h"

#include <string.h>

#define NEAR_WRAP_AXIS 1U
#define NEAR_WRAP_READING (INT32_MAX - 100)
#define CORRUPT_BYTE 40U
#define FOREIGN_FIRMWARE (SIM_CARD_FIRMWARE + 1U)
#define NOISE 50U /* A noisy wire damages one in so many commands. */
#define WARM_C 62.0
#define HOT_C 70.0
#define LOW_MV 18000U
#define HIGH_MV 30000U

static void init_axis(box_axis_t *self, const robot_t *robot, uint32_t index, sim_random_t *random)
{
    const axis_config_t *const config = &robot->axes[index];
    const double position = robot->start_ticks[index];
    const int32_t reading =
        (index == NEAR_WRAP_AXIS) ? NEAR_WRAP_READING : 1000 * ((int32_t)config->slot + 1);

    self->config = config;
    self->card_fault = BOX_CARD_NORMAL;
    sim_motor_init(&self->motor, config, position, sim_random_signed(random) * SIM_MOTOR_ASYMMETRY);
    sim_encoder_init(&self->encoder, config, position, reading, sim_random_next(random));
    sim_switch_init(&self->limit_switch, config, position, sim_random_next(random));
    sim_card_init(&self->card, config, &self->encoder, self->limit_switch.is_active, 0U);
}

static void init_sensor(box_sensor_t *self, uint32_t slot, uint32_t card_type, uint32_t time_us)
{
    const axis_config_t config = {.slot = (uint8_t)slot, .card_type = (uint8_t)card_type};

    (void)memset(self, 0, sizeof *self);
    sim_encoder_init(&self->encoder, &config, 0.0, 0, 1U);
    sim_card_init(&self->card, &config, &self->encoder, false, time_us);
}

/* On two converters, as the platform has it: the force of the hand, and the force on the needle. */
void box_read_cells(box_t *self)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        uint32_t *const adc = self->sensors[slot].card.adc;
        adc[BOX_HAND_CONVERTER] = self->force.cells[SIM_CELL_HAND].reading;
        adc[BOX_NEEDLE_CONVERTER] = self->force.cells[SIM_CELL_NEEDLE].reading;
    }
}

static bool has_sensor(const box_t *self, uint32_t slot)
{
    return ((self->sensor_slots >> slot) & 1U) != 0U;
}

void box_plug(box_t *self, uint32_t slot, uint32_t card_type)
{
    const uint32_t bit = 1U << slot;

    self->sensor_slots &= ~bit;
    if (card_type != (uint32_t)CARD_TYPE_NONE) {
        init_sensor(&self->sensors[slot], slot, card_type, (uint32_t)self->time_us);
        self->sensor_slots |= bit;
        box_read_cells(self);
    }
}

const sim_phantom_file_t *box_usual_phantom(const robot_t *robot)
{
    static const sim_phantom_file_t none = {.tissue = {.layer_count = 0U}};
    bool has_sensor_card = false;

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        has_sensor_card = has_sensor_card || robot_cards_has_sensor(robot, slot);
    }
    return has_sensor_card ? &sim_phantom_usual : &none;
}

void box_init(box_t *self, const robot_t *robot, uint32_t seed)
{
    (void)memset(self, 0, sizeof *self);
    self->robot = robot;
    self->random.state = seed;
    self->estop.is_closed = true;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        init_axis(&self->axes[i], robot, i, &self->random);
    }
    box_force_init(&self->force, box_usual_phantom(robot), box_depth_mm(self), box_turn_rad(self),
                   &self->random);
    sim_imager_init(&self->imager, sim_random_next(&self->random));
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (robot_cards_has_sensor(robot, slot)) {
            box_plug(self, slot, (uint32_t)CARD_TYPE_SENSOR);
        }
    }
}

/* Sets the card's measurements of itself while it has this fault. */
static void feign(sim_card_t *card, box_card_fault_t fault)
{
    card->firmware = (fault == BOX_CARD_FOREIGN) ? FOREIGN_FIRMWARE : SIM_CARD_FIRMWARE;
    card->feigned_driver_c = (fault == BOX_CARD_WARM)  ? WARM_C
                             : (fault == BOX_CARD_HOT) ? HOT_C
                                                       : 0.0;
    card->supply_mv = (fault == BOX_CARD_LOW)    ? LOW_MV
                      : (fault == BOX_CARD_HIGH) ? HIGH_MV
                                                 : SIM_CARD_SUPPLY_MV;
}

static void hear(sim_card_t *card, box_card_fault_t fault, const uint8_t frame[CARD_FRAME_BYTES])
{
    uint8_t heard[CARD_FRAME_BYTES];

    (void)memcpy(heard, frame, sizeof heard);
    if ((fault == BOX_CARD_NOISY) && (card->heartbeat % NOISE == 0U)) {
        heard[CORRUPT_BYTE] ^= 0x10U;
    }
    if (fault != BOX_CARD_DEAF) {
        sim_card_receive(card, heard);
    }
}

static bool exchange_card(sim_card_t *card, sim_encoder_t *encoder, box_card_fault_t fault,
                          const uint8_t frame[CARD_FRAME_BYTES], uint8_t received[CARD_FRAME_BYTES])
{
    if (fault == BOX_CARD_SILENT) {
        return false;
    }
    feign(card, fault);
    sim_card_report(card, encoder, received);
    if (fault == BOX_CARD_CORRUPT) {
        received[CORRUPT_BYTE] ^= 0x10U;
    }
    hear(card, fault, frame);
    return true;
}

uint32_t box_exchange(box_t *self, uint32_t send,
                      const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                      uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    uint32_t answered = 0U;

    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        box_axis_t *axis = &self->axes[i];
        const uint32_t slot = axis->config->slot;
        const uint32_t bit = 1U << slot;
        if (((send & bit) != 0U) && exchange_card(&axis->card, &axis->encoder, axis->card_fault,
                                                  frames[slot], received[slot])) {
            answered |= bit;
        }
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        box_sensor_t *sensor = &self->sensors[slot];
        const uint32_t bit = 1U << slot;
        if (((send & bit) != 0U) && has_sensor(self, slot) &&
            exchange_card(&sensor->card, &sensor->encoder, sensor->card_fault, frames[slot],
                          received[slot])) {
            answered |= bit;
        }
    }
    return answered;
}

static double ticks_of_nm(const axis_config_t *needle, double nm)
{
    return nm * 65536.0 / (double)needle->unit_per_tick_q16;
}

double box_depth_mm(const box_t *self)
{
    const box_axis_t *const needle = &self->axes[self->robot->needle_axis];
    const double ticks = needle->motor.position_ticks + self->probe.free_ticks;

    return ticks * (double)needle->config->unit_per_tick_q16 / 65536.0 / 1e6;
}

void box_push(box_t *self, double mm)
{
    self->probe.to_go_ticks = ticks_of_nm(&self->robot->axes[self->robot->needle_axis], mm * 1e6);
}

/* Way that the hand pushes in this step, ticks. */
static double step_hand(box_t *self)
{
    const axis_config_t *const needle = &self->robot->axes[self->robot->needle_axis];
    const double most = ticks_of_nm(needle, (double)BOX_HAND_NM_PER_S * SIM_STEP_US / 1e6);
    double way = self->probe.to_go_ticks;

    way = (way > most) ? most : (way < -most) ? -most : way;
    self->probe.to_go_ticks -= way;
    return way;
}

/* A free probe goes alone. Returns by how many ticks the needle's axis is pushed. */
static double step_probe(box_t *self)
{
    const double way = step_hand(self);

    if (!self->probe.is_free) {
        return way;
    }
    self->probe.free_ticks += way;
    return 0.0;
}

/* A pulled e-stop and the amplifier-off line take the drivers' supply away, whatever the cards
 * say. */
static bool has_power(const box_t *self)
{
    return self->estop.is_closed && !self->is_off;
}

static void step_axis(box_axis_t *axis, double pushed_ticks, const box_t *box)
{
    const double before_ticks = axis->motor.position_ticks;
    const uint32_t start_us = (uint32_t)box->time_us;
    const bool is_scanning = box->scanner_active;
    const bool is_powered = has_power(box);

    axis->card.is_motor_hot = axis->motor.fault == SIM_MOTOR_HOT;
    axis->motor.temperature_c = axis->card.motor_temperature_c;
    sim_motor_push(&axis->motor, pushed_ticks);
    sim_motor_step(&axis->motor, &axis->card.applied, is_powered);
    sim_encoder_step(&axis->encoder, before_ticks, axis->motor.position_ticks, start_us,
                     is_scanning);
    sim_switch_step(&axis->limit_switch, axis->motor.position_ticks);
    sim_card_step(&axis->card, &axis->encoder, axis->limit_switch.is_active, is_powered);
}

static void step_contact(box_contact_t *contact)
{
    if (contact->delay_us > SIM_STEP_US) {
        contact->delay_us -= SIM_STEP_US;
    } else if (contact->delay_us > 0U) {
        contact->delay_us = 0U;
        contact->is_closed = contact->will_be_closed;
    } else {
        /* settled */
    }
}

static void latch(box_t *self)
{
    self->dropped |= box_inputs(self) ^ BSP_IN_ALL;
}

/* True if no step moves it: it needs no step of its own for as long as nobody gives orders. */
static bool does_rest(const box_t *self, uint32_t index)
{
    const box_axis_t *const axis = &self->axes[index];
    const double to_go_ticks = self->probe.to_go_ticks;
    const bool is_pushed = (index == self->robot->needle_axis) && !self->probe.is_free &&
                           (to_go_ticks * to_go_ticks > 0.0);

    return !is_pushed && !self->scanner_active &&
           (axis->card.applied.mode == (uint32_t)CARD_DRIVE_OFF) &&
           (axis->motor.fault != SIM_MOTOR_RUNS) &&
           sim_encoder_is_quiet(&axis->encoder, axis->motor.position_ticks) &&
           sim_switch_is_settled(&axis->limit_switch, axis->motor.position_ticks);
}

/* All at once; power comes and goes with the e-stop. */
static uint32_t resting_axes(const box_t *self)
{
    uint32_t axes = 0U;

    for (uint32_t i = 0U; (i < self->robot->axis_count) && (self->estop.delay_us == 0U); i++) {
        axes |= does_rest(self, i) ? (1U << i) : 0U;
    }
    return axes;
}

static void rest_axis(box_axis_t *axis, bool is_powered, uint32_t steps)
{
    axis->card.is_motor_hot = axis->motor.fault == SIM_MOTOR_HOT;
    axis->motor.speed_ticks_per_s = 0.0;
    sim_encoder_rest(&axis->encoder, steps);
    sim_card_rest(&axis->card, &axis->encoder, axis->limit_switch.is_active, is_powered, steps);
    axis->motor.temperature_c = axis->card.motor_temperature_c;
}

static void rest(box_t *self, uint32_t axes, uint32_t steps)
{
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        if (((axes >> i) & 1U) != 0U) {
            rest_axis(&self->axes[i], has_power(self), steps);
        }
    }
}

static void step(box_t *self, uint32_t resting)
{
    latch(self);
    step_contact(&self->pedal_a);
    step_contact(&self->pedal_b);
    step_contact(&self->estop);
    const double pushed_ticks = step_probe(self);
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        if (((resting >> i) & 1U) == 0U) {
            step_axis(&self->axes[i], (i == self->robot->needle_axis) ? pushed_ticks : 0.0, self);
        }
    }
    box_force_step(&self->force, SIM_STEP_US, box_depth_mm(self), box_turn_rad(self));
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (has_sensor(self, slot)) {
            box_sensor_t *sensor = &self->sensors[slot];
            sim_card_step(&sensor->card, &sensor->encoder, false, has_power(self));
        }
    }
    self->time_us += SIM_STEP_US;
    box_image_tip(self);
}

void box_advance(box_t *self, uint32_t us)
{
    const uint64_t total_us = (uint64_t)self->pending_us + us;
    const uint32_t steps = (uint32_t)(total_us / SIM_STEP_US);
    const uint32_t resting = resting_axes(self);

    for (uint32_t i = 0U; i < steps; i++) {
        step(self, resting);
    }
    rest(self, resting, steps);
    box_read_cells(self);
    self->pending_us = (uint32_t)(total_us % SIM_STEP_US);
}

uint32_t box_inputs(const box_t *self)
{
    return (self->pedal_a.is_closed ? BSP_IN_PEDAL_A : 0U) |
           (self->pedal_b.is_closed ? BSP_IN_PEDAL_B : 0U) |
           (self->estop.is_closed ? BSP_IN_ESTOP_CHAIN : 0U) |
           (self->scanner_active ? 0U : BSP_IN_SCANNER_IDLE) |
           (self->button_pressed ? BSP_IN_CONFIRM : 0U) |
           ((self->gate == BOX_GATE_DOSE) ? 0U : BSP_IN_DOSE_BELOW) |
           ((self->gate == BOX_GATE_STOP) ? 0U : BSP_IN_TREATMENT_MAY);
}

bsp_inputs_t box_sample(box_t *self)
{
    latch(self);
    const bsp_inputs_t sample = {
        .levels = box_inputs(self), .dropped = self->dropped, .valid = BSP_IN_ALL};
    self->dropped = sample.levels ^ BSP_IN_ALL;
    return sample;
}

void box_true_positions(const box_t *self, double positions_ticks[ROBOT_AXIS_MAX])
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        positions_ticks[i] = self->axes[i].motor.position_ticks;
    }
}

void box_contact_set(box_contact_t *contact, bool is_closed, uint32_t delay_us)
{
    contact->will_be_closed = is_closed;
    contact->delay_us = delay_us;
    if (delay_us == 0U) {
        contact->is_closed = is_closed;
    }
}
