/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A robot as data. tools/compile/robot_compiler.rb makes of core/robot/<name>/robot.yml the table
 * robot_<name>, and a header of the same name with the order of its axes and lengths; nothing else
 * describes a robot. Programs find the tables by robots_find().
 */
#ifndef BORESIGHT_ROBOT_H
#define BORESIGHT_ROBOT_H

#include "card/card.h"
#include "interface/pose_name.h"

#include <stdint.h>

#define ROBOT_AXIS_MAX 10U        /**< Most axes of any robot; what a robot has is axis_count. */
#define ROBOT_COUPLED_LIMITS 4U   /**< Most coupled limits of any robot. */
#define ROBOT_GEOMETRY_MAX 11U    /**< Most lengths of the geometry of any robot. */
#define ROBOT_FORCE_CHANNELS 2U   /**< Channels of a force sensor, by force_channel_id_t. */
#define ROBOT_HOME_STAGES 4U      /**< Most stages of homing. */
#define ROBOT_PROBE_LENGTHS 4U    /**< Most lengths of the probe of any robot. */
#define ROBOT_STEERING_POINTS 8U  /**< Most points of a needle's table of curvatures. */
#define ROBOT_REPORTED_LENGTHS 4U /**< Most lengths that clients are sent. */
#define ROBOT_CURVE_STEPS 8U  /**< Into so many the words of a high-frequency card are divided. */
#define ROBOT_CURVE_FULL 255U /**< Full speed in them. */

typedef enum {
    HOME_BY_SWITCH = 0, /**< Drives to its limit switch. */
    HOME_IN_PLACE = 1   /**< Has no switch: where it stands at START_UP is its home position. */
} home_method_t;

typedef enum {
    LIMIT_SWITCH_NONE = 0,
    LIMIT_SWITCH_LOWER = 1, /**< At the low end: blocks motion towards smaller positions. */
    LIMIT_SWITCH_UPPER = 2  /**< At the high end. */
} limit_switch_t;

/** Motion of the needle by an axis. */
typedef enum {
    NEEDLE_ACROSS = 0, /**< Sideways, or about another line than its own. */
    NEEDLE_ALONG = 1,  /**< Along its line; larger positions are deeper. */
    NEEDLE_ABOUT = 2   /**< About its line. */
} needle_motion_t;

typedef enum {
    AXIS_UNIT_MM = 0, /**< Joint value in nm. */
    AXIS_UNIT_RAD = 1 /**< Joint value in bam. */
} axis_unit_t;

/** Type of the motor of an axis. */
typedef enum {
    MOTOR_TYPE_SHINSEI = 0, /**< Ultrasonic, rotating. */
    MOTOR_TYPE_PIEZO = 1,   /**< Walking or rubbing piezo elements. */
    MOTOR_TYPE_DTI = 2
} motor_type_t;

/** One axis. Positions in ticks (encoder counts), home = the position its home method assigns. No
 * padding before `seal`. */
typedef struct {
    int64_t unit_per_tick_q16; /**< nm or bam per tick, 16 fraction bits. */
    char name[12];
    uint8_t slot;                /**< Card slot 0..9. */
    uint8_t card_type;           /**< card_type_t. */
    uint8_t unit;                /**< axis_unit_t. */
    uint8_t limit_switch;        /**< limit_switch_t. */
    uint8_t home_method;         /**< home_method_t. */
    uint8_t home_stage;          /**< 1..ROBOT_HOME_STAGES, one after the other. */
    uint8_t is_motor_inverted;   /**< 1: direction bit 1 makes the position smaller. */
    uint8_t is_encoder_inverted; /**< 1: position grows when the reading falls. */
    /** At n - 1, of stage n: 1 + index of the axis that it follows while that homes by its switch;
     * 0: none. Both have the same ticks a unit. */
    uint8_t leaders[ROBOT_HOME_STAGES];
    uint8_t motor_type;        /**< motor_type_t. */
    uint8_t amplitude;         /**< Amplitude of the waves of a high-frequency card; otherwise 0. */
    uint8_t reversal_dwell_ms; /**< Its motor rests for so long between two directions. */
    /** Drop of the motor's resonance for each kelvin that it is warmer than LIMIT_MOTOR_TABLE_DC,
     * with a high-frequency card. Otherwise 0. */
    uint8_t resonance_hz_per_k;
    /** Speeds with a high-frequency card: at n, the speed after n of the equal steps that lead from
     * the slowest word to the fastest, where it is ROBOT_CURVE_FULL. Otherwise 0. */
    uint8_t speed_curve[ROBOT_CURVE_STEPS];
    uint32_t needle_motion; /**< needle_motion_t. */
    int32_t minimum_ticks;  /**< Soft limits, inclusive. */
    int32_t maximum_ticks;
    int32_t home_ticks;
    int32_t deadband_ticks;    /**< |set-point - position| at rest that counts as arrived. */
    int32_t speed_ticks_per_s; /**< Highest speed of a move. */
    int32_t acceleration_ticks_per_s2;
    int32_t home_speed_ticks_per_s;
    int32_t full_speed_ticks_per_s; /**< Speed of the motor at the largest drive word (or when
                                       running). */
    int32_t following_error_ticks;  /**< Largest |set-point - position| while driven... */
    uint16_t following_time_ms;     /**< ...beside the way of this time at the set-point speed. */
    uint16_t drift_ticks;           /**< Most that it may have counted at rest since its last
                                       reference, confirmations not counted as one, to be
                                       homed and for a target to stay. */
    int32_t jump_ticks;             /**< Largest believable change of the reading in one cycle. */
    /** Way back until the limit switch releases; 0 without one. */
    int32_t switch_hysteresis_ticks;
    int32_t home_way_ticks;       /**< The farthest that homing goes away from the switch: its
                                     over-travel, hysteresis and 0.1 mm or 0.3 degrees; the
                                     needle 0.2 mm at most. */
    int32_t target_minimum_ticks; /**< Lowest place of a target, inclusive: where the limit switch
                                     is surely free. */
    int32_t target_maximum_ticks;
    uint32_t home_time_us; /**< Longest driven time of a leg of homing. */
    uint32_t minimum_duty; /**< Word of a drive that just moves the motor. */
    uint32_t maximum_duty; /**< Word of full speed, saturates; 0: the drive has none, it is run or
                              stop. A high-frequency card's is smaller than minimum_duty. */
    int32_t hottest_dc;    /**< Temperature of the motor above which it is not driven, 0.1 degree
                              Celsius. */
    uint32_t gain_per_s;   /**< Speed demanded for each tick of error, ticks/s; 0 without
                              magnitudes. */
    uint32_t seal;         /**< seal_of() all before it; the last field. */
} axis_config_t;

/** A limit that axes share: what kinematics_coupled() says of them, in nm or bam, lies in a range.
 * No padding. */
typedef struct {
    char name[12];
    uint8_t unit;      /**< axis_unit_t of the value, whatever that of the axes. */
    uint8_t refusal;   /**< status_t of who would miss it. */
    uint8_t is_curved; /**< 0: while axes go in step the value only rises or only falls. */
    uint8_t reserved;  /**< 0. */
    uint32_t axes;     /**< Bit n: axis n has part in it. */
    int32_t minimum;   /**< Both ends inclusive. */
    int32_t maximum;
} coupled_limit_t;

/** A pose: where each axis stands, surely free of its limit switch; only POSE_HOME has a place for
 * the needle. */
typedef struct {
    int32_t ticks[ROBOT_AXIS_MAX];
    uint32_t seal; /**< seal_of() all before it. */
} pose_t;

/** A channel of the force sensor: how its converter's reading becomes a force, and which readings
 * can be true. */
typedef struct {
    int32_t mn_per_count_q16; /**< Never 0; a push is a positive force. */
    /** Butterworth low-pass of second order: y = b (x + 2 x1 + x2) - a1 y1 - a2 y2, with
     * 4 b = 1 + a1 + a2. */
    int32_t filter_b_q30;
    int32_t filter_a1_q30;
    int32_t filter_a2_q30;
    uint32_t zero_count; /**< Reading without a force, as it was known last. */
    uint32_t
        minimum_count; /**< Both inclusive: readings of the forces that the sensor is made for. */
    uint32_t maximum_count;
    uint32_t step_counts; /**< Most from one report to the next. */
    uint32_t converter;   /**< Of the card, from 0. */
} force_channel_config_t;

/** The force sensor of a robot. No padding before `seal`. */
typedef struct {
    uint32_t is_there; /**< 0 or 1; 0: all of it is 0. */
    uint32_t slot;     /**< Slot of its card, one of sensor_slots. */
    force_channel_config_t channels[ROBOT_FORCE_CHANNELS];
    uint32_t seal; /**< seal_of() all before it. */
} force_config_t;

/** The lengths of a probe or needle, in the order of the robot file; named by the robot's own
 * header. 0 beyond those of the robot. */
typedef struct {
    int32_t length_nm[ROBOT_PROBE_LENGTHS];
} probe_t;

/** A length that planning clients are sent. */
typedef struct {
    char name[24];     /**< At most 20 characters; empty: none. */
    int32_t length_nm; /**< As the robot file has it. */
    uint32_t probe;    /**< 1 + place in probe_t: that of the present probe is sent; 0: of none. */
} reported_length_t;

/** How a hand that pushes moves the needle (motion/admittance.h). All 0: no hand moves it. */
typedef struct {
    uint32_t dead_zone_mn;      /**< Up to this force the needle stands. */
    uint32_t gain_q8;           /**< Speed for each mN beyond it, ticks/s, 8 fraction bits. */
    uint32_t speed_ticks_per_s; /**< Highest speed. */
    uint32_t stop_ticks_per_s2; /**< Change of the set-point's speed once the hand pushes less. */
} hand_law_t;

/** How the needle vibrates as a feedback to the hand (motion/vibration.h). All 0: it does not. */
typedef struct {
    uint32_t amplitude_ticks;
    uint32_t stroke_cycles; /**< Of one way, back or forward. */
    uint32_t dwell_cycles;  /**< Rest before each. */
    uint32_t periods;       /**< Number of strokes back, each with one forward. */
} vibration_law_t;

/** How far the needle is bent by its rotation (robot/steering.h). All 0: it is not steered. */
typedef struct {
    uint32_t axis;           /**< Index of the axis that turns it. */
    uint32_t points;         /**< Of the table that are used, 2..ROBOT_STEERING_POINTS. */
    uint32_t most_per_km;    /**< Largest curvature: that of the slowest drive of the axis. */
    uint32_t needle_percent; /**< Share of its speed with which the needle goes in: at the largest
                                curvature by LIMIT_STEERING_ADVANCE_UM in a turn. */
    uint32_t curvature_per_km[ROBOT_STEERING_POINTS]; /**< 1 / radius; from 0, each larger than the
                                                         one before. */
    uint32_t alpha_q16[ROBOT_STEERING_POINTS];        /**< Strength for it, 0..65536; the same. */
} steering_law_t;

/** A robot. No padding before `seal`. */
typedef struct {
    char name[12];
    uint32_t axis_count;
    uint32_t crc;           /**< CRC-32C of the robot file the table was compiled from. */
    uint32_t kind;          /**< ROBOT_KIND_: whose kinematics. */
    uint32_t card_firmware; /**< Firmware of every card: major << 16 | minor << 8 | patch. */
    uint32_t sensor_slots;  /**< Bit n: slot n holds a card without an axis, CARD_TYPE_SENSOR. */
    uint32_t needle_axis;   /**< The axis that moves the needle along its line. */
    uint32_t pose_mask;     /**< Bit n: it has the pose n of pose_name_t. */
    uint32_t coupled_limit_count;
    coupled_limit_t coupled_limits[ROBOT_COUPLED_LIMITS];
    int32_t geometry_nm[ROBOT_GEOMETRY_MAX]; /**< In the order of the robot file; named by the
                                                robot's own header. */
    uint32_t probe_length_count;
    probe_t probe;         /**< The one to start with; plan_t has the present one. */
    probe_t probe_minimum; /**< Both ends inclusive. */
    probe_t probe_maximum;
    uint8_t probe_within[ROBOT_PROBE_LENGTHS]; /**< 1 + place of the length that it may not exceed;
                                                  0: of none. */
    hand_law_t hand;                           /**< How a hand moves the needle. */
    vibration_law_t vibration;                 /**< How that hand is answered. */
    steering_law_t steering;                   /**< How far the needle is bent. */
    uint32_t seal;                             /**< seal_of() all before it. */
    axis_config_t axes[ROBOT_AXIS_MAX];
    pose_t poses[POSE_NAME_COUNT]; /**< By pose_name_t. */
    force_config_t force;          /**< Compared with its seal by itself. */
    int32_t
        start_ticks[ROBOT_AXIS_MAX]; /**< Places of the simulated axes when their box is switched
                                        on; nothing else reads it, so it has no seal. */
    /** Names of the probe's lengths for people, and the values that planning clients are sent: axes
     * in the order of lists, and lengths. Nothing that moves reads it, so it has no seal. */
    char probe_names[ROBOT_PROBE_LENGTHS][24];
    uint8_t reported_joints[ROBOT_AXIS_MAX];
    reported_length_t reported_lengths[ROBOT_REPORTED_LENGTHS];
    /** Along which the needle goes to a target that is a bare point, in the z-frame, each -1 to 1;
     * all 0: a point needs an entry point. */
    int32_t bare_direction[3];
} robot_t;

#endif
