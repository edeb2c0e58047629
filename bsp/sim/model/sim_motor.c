/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_motor.h"

#include "limits/requirement_limits.h"

/* 1 - exp(-step / time constant), written out so that no mathematics library decides about the last
 * bit. */
#define RISE_SHARE 0.006644493744965585
#define FALL_SHARE 0.06449301496838226
#define STEP_S 0.0001
#define STOP_BEYOND_TICKS 60.0
#define STOP_BEYOND_SHARE 0.02
#define WORDS_PER_KHZ 22009000.0
#define SWEEP_FIRST_KHZ 54.369
#define SWEEP_STEP_KHZ (4063228.0 / WORDS_PER_KHZ)
#define SWEEP_POINTS 24
#define RESONANCE_KHZ 49.5

/* Turns a minute by frequency, falling from SWEEP_FIRST_KHZ: the public sweep of a motor of this
 * platform, upwards and downwards. */
static const double sweep[SWEEP_POINTS][2] = {
    {0.0, 0.0},     {0.029, 0.054}, {0.164, 0.189}, {0.289, 0.331}, {0.431, 0.614}, {0.640, 1.095},
    {0.963, 2.020}, {1.459, 3.222}, {2.660, 3.773}, {5.181, 6.383}, {11.44, 10.64}, {13.46, 15.31},
    {20.96, 20.23}, {27.36, 27.24}, {36.04, 35.24}, {45.55, 45.33}, {59.00, 58.50}, {78.71, 77.52},
    {105.9, 103.3}, {141.4, 138.2}, {188.1, 183.9}, {247.4, 242.8}, {317.4, 312.8}, {397.8, 391.7},
};

/* By motor_type_t. */
static const struct {
    uint32_t warmer_k;
    uint32_t warming_s;
    uint32_t speed_loss_permille;
    uint32_t torque_loss_permille;
} heats[] = {{LIMIT_SHINSEI_WARMER_K, LIMIT_SHINSEI_WARMING_S, LIMIT_SHINSEI_SPEED_LOSS_PERMILLE,
              LIMIT_SHINSEI_TORQUE_LOSS_PERMILLE},
             {LIMIT_PIEZO_WARMER_K, LIMIT_PIEZO_WARMING_S, LIMIT_PIEZO_SPEED_LOSS_PERMILLE,
              LIMIT_PIEZO_TORQUE_LOSS_PERMILLE},
             {LIMIT_DTI_WARMER_K, LIMIT_DTI_WARMING_S, LIMIT_DTI_SPEED_LOSS_PERMILLE,
              LIMIT_DTI_TORQUE_LOSS_PERMILLE}};

static bool has_waves(const axis_config_t *axis)
{
    return axis->card_type == (uint8_t)CARD_TYPE_HIGH_FREQUENCY;
}

sim_heat_t sim_motor_heat(const axis_config_t *axis)
{
    const uint32_t type = axis->motor_type;
    const uint32_t warmer_k = has_waves(axis) ? LIMIT_WAVES_WARMER_K : heats[type].warmer_k;

    return (sim_heat_t){.settled_c = warmer_k,
                        .warming_share = STEP_S / heats[type].warming_s,
                        .speed_loss = heats[type].speed_loss_permille / 1000.0,
                        .torque_loss = heats[type].torque_loss_permille / 1000.0,
                        .resonance_khz = axis->resonance_hz_per_k / 1000.0};
}

/* As published, from the last point on as there. */
static double swept_speed(double khz, uint32_t column)
{
    const double at = (SWEEP_FIRST_KHZ - khz) / SWEEP_STEP_KHZ;

    if ((at <= 0.0) || (khz < RESONANCE_KHZ)) {
        return 0.0;
    }
    if (at >= (double)(SWEEP_POINTS - 1)) {
        return sweep[SWEEP_POINTS - 1][column];
    }
    const uint32_t point = (uint32_t)at;
    return sweep[point][column] +
           (sweep[point + 1U][column] - sweep[point][column]) * (at - (double)point);
}

static void init_waves(sim_motor_t *self, const axis_config_t *axis)
{
    const double khz = self->maximum_duty / WORDS_PER_KHZ;
    const double mean = (swept_speed(khz, 0U) + swept_speed(khz, 1U)) / 2.0;

    self->has_waves = has_waves(axis);
    self->amplitude = axis->amplitude;
    self->scale = self->has_waves ? 1.0 / mean : 0.0;
}

void sim_motor_init(sim_motor_t *self, const axis_config_t *axis, double position_ticks,
                    double asymmetry)
{
    const double range = (double)axis->maximum_ticks - (double)axis->minimum_ticks;
    const double beyond = range * STOP_BEYOND_SHARE;

    *self = (sim_motor_t){.full_speed_ticks_per_s = axis->full_speed_ticks_per_s,
                          .asymmetry = asymmetry,
                          .rise_share = RISE_SHARE,
                          .minimum_duty = axis->minimum_duty,
                          .maximum_duty = axis->maximum_duty,
                          .lowest_ticks = (double)axis->minimum_ticks - beyond,
                          .highest_ticks = (double)axis->maximum_ticks + beyond,
                          .is_inverted = axis->is_motor_inverted != 0U,
                          .heat = sim_motor_heat(axis),
                          .temperature_c = SIM_MOTOR_AIR_C,
                          .position_ticks = position_ticks};
    init_waves(self, axis);
    if (axis->limit_switch == (uint8_t)LIMIT_SWITCH_LOWER) {
        self->lowest_ticks = (double)axis->minimum_ticks - STOP_BEYOND_TICKS;
    }
    if (axis->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER) {
        self->highest_ticks = (double)axis->maximum_ticks + STOP_BEYOND_TICKS;
    }
}

static double magnitude_share(const sim_motor_t *self, uint32_t duty)
{
    const double span = self->maximum_duty - self->minimum_duty;
    const double above = (double)duty - self->minimum_duty;

    if ((above < 0.0) || (span <= 0.0)) {
        return 0.0;
    }
    if (above >= span) {
        return 1.0;
    }
    return SIM_MOTOR_SLOWEST + (1.0 - SIM_MOTOR_SLOWEST) * above / span;
}

/* Above that of its table. */
static double warmth_k(const sim_motor_t *self)
{
    const double above = self->temperature_c - (double)LIMIT_MOTOR_TABLE_DC / 10.0;

    return (above > 0.0) ? above : 0.0;
}

/* Share of full speed, in the direction of the drive. Its whole curve falls with its resonance. */
static double wave_share(const sim_motor_t *self, const card_drive_t *drive, bool is_upwards)
{
    const double khz =
        (double)drive->duty / WORDS_PER_KHZ + warmth_k(self) * self->heat.resonance_khz;

    return swept_speed(khz, is_upwards ? 0U : 1U) * self->scale *
           ((double)drive->amplitude / self->amplitude);
}

/* Share of it that warmth and load leave. */
static double left_share(const sim_motor_t *self)
{
    const double torque = 1.0 - warmth_k(self) * self->heat.torque_loss;
    const double speed = 1.0 - warmth_k(self) * self->heat.speed_loss;

    return (self->load < torque) ? speed * (1.0 - self->load / torque) : 0.0;
}

double sim_motor_steady_speed(const sim_motor_t *self, const card_drive_t *drive)
{
    const bool is_run =
        (drive->mode == (uint32_t)CARD_DRIVE_NON_PWM) && (self->maximum_duty <= 0.0);
    const bool is_upwards = (drive->direction != 0U) != self->is_inverted;
    double share = is_run ? 1.0 : magnitude_share(self, drive->duty);

    if (self->has_waves) {
        share = wave_share(self, drive, is_upwards);
    }
    if (drive->mode == (uint32_t)CARD_DRIVE_OFF) {
        return 0.0;
    }
    share *= (self->fault == SIM_MOTOR_HALF) ? 0.5 : (self->fault == SIM_MOTOR_TWICE) ? 2.0 : 1.0;
    share *= left_share(self);
    if ((share < SIM_MOTOR_SLOWEST) && !self->has_waves) {
        return 0.0;
    }
    const double speed = share * self->full_speed_ticks_per_s;
    return is_upwards ? speed * (1.0 + self->asymmetry) : -speed * (1.0 - self->asymmetry);
}

static bool is_gaining(double speed, double steady)
{
    const double most = (speed < 0.0) ? -speed : speed;
    return (steady > most) || (steady < -most);
}

static double approach(const sim_motor_t *self, double speed, double steady)
{
    if ((speed * steady >= 0.0) && is_gaining(speed, steady)) {
        return speed + (steady - speed) * self->rise_share;
    }
    if (speed * steady < 0.0) {
        /* A reversal first stops: the fall ends at zero, from where the new direction rises. */
        const double fallen = speed + (steady - speed) * FALL_SHARE;
        return (fallen * speed > 0.0) ? fallen : 0.0;
    }
    return speed + (steady - speed) * FALL_SHARE;
}

/* A hard stop ends its motion. */
static void advance(sim_motor_t *self, double ticks)
{
    self->position_ticks += ticks;
    if (self->position_ticks > self->highest_ticks) {
        self->position_ticks = self->highest_ticks;
        self->speed_ticks_per_s = 0.0;
    }
    if (self->position_ticks < self->lowest_ticks) {
        self->position_ticks = self->lowest_ticks;
        self->speed_ticks_per_s = 0.0;
    }
}

void sim_motor_push(sim_motor_t *self, double ticks)
{
    if (ticks * ticks > 0.0) {
        advance(self, ticks);
    }
}

void sim_motor_step(sim_motor_t *self, const card_drive_t *drive, bool is_powered)
{
    const bool is_running =
        (self->fault == SIM_MOTOR_RUNS) || (drive->mode != (uint32_t)CARD_DRIVE_OFF);
    if (!is_powered || !is_running || (self->fault == SIM_MOTOR_STUCK)) {
        self->speed_ticks_per_s = 0.0;
        return;
    }
    const double steady = (self->fault == SIM_MOTOR_RUNS) ? self->full_speed_ticks_per_s / 2.0
                                                          : sim_motor_steady_speed(self, drive);
    self->speed_ticks_per_s = approach(self, self->speed_ticks_per_s, steady);
    advance(self, self->speed_ticks_per_s * STEP_S);
}
