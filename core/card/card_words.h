/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The words of both frames, for the codec alone. A line of a comment is a field, `BITS NAME: what
 * it says; its values`; tools/documents/card_tables.rb makes of them the tables that a card's
 * vendor reads.
 */
#ifndef BORESIGHT_CARD_WORDS_H
#define BORESIGHT_CARD_WORDS_H

/** 31..0 start: where a frame begins; 0xFEFEFE01. */
#define CARD_BOTH_START 0U
/**
 * 31..24 protocol: version of this layout; 1.
 * 23..16 slot: of the card; 0 to 9.
 * 15..8 length: of the frame in words; 64.
 * 7..0 kind: of the frame; 1 command, 2 report.
 */
#define CARD_BOTH_HEADER 1U
/** 31..0 sum: of the words 0 to 61; 0xFFFFFFFF minus it, modulo 2^32. */
#define CARD_BOTH_LEGACY_SUM 62U
/** 31..0 crc: over the 252 bytes before it; CRC-32C. */
#define CARD_BOTH_CRC 63U

/** 31..0 sequence: grows by one each exchange; any, wraps. */
#define CARD_COMMAND_SEQUENCE 2U
/** 31..0 time: of the controller, us; any, wraps. */
#define CARD_COMMAND_TIME 3U
/**
 * 31..16 unused: not used; 0.
 * 15..8 workphase: of the controller, for a display; its number.
 * 7..0 system: what the controller is in; bits of the system state.
 */
#define CARD_COMMAND_SYSTEM 4U
/** 31..0 control: what the card shall do; bits of control, all others 0. */
#define CARD_COMMAND_CONTROL 5U
/** 31..0 wave_1: frequency of wave 1, Hz x 22009; {wave_fastest_word} to {wave_slowest_word},
 * the smaller the faster the motor, 0 without waves. */
#define CARD_COMMAND_WAVES 6U
/**
 * 24 table_1: wave 1 leads, 1 when the direction is 0; all other upper bits 0.
 * 15..0 amplitude_1: of wave 1; 1 to 255.
 */
#define CARD_COMMAND_WAVE_1_SHAPE 7U
/** 31..0 wave_2: frequency of wave 2; the same as of wave 1. */
#define CARD_COMMAND_WAVE_2 8U
/**
 * 24 table_2: wave 2 leads, 1 when the direction is 1; all other upper bits 0.
 * 15..0 amplitude_2: of wave 2; the same as of wave 1.
 */
#define CARD_COMMAND_WAVE_2_SHAPE 9U
/**
 * 31..24 mode: what the drive does; a drive mode.
 * 23..16 direction: meant by the robot's table; 0 or 1, 0 when off.
 * 15..0 unused: not used; 0.
 */
#define CARD_COMMAND_MODE 10U
/** 31..0 duty: of pwm, or the magnitude of a card without it; 0 to 0x7FFFFF, otherwise 0. */
#define CARD_COMMAND_DUTY 11U
/**
 * 31..16 converter: magnitude of an analog drive; 0 to 65535, otherwise 0.
 * 15..0 unused: not used; 0.
 */
#define CARD_COMMAND_CONVERTERS 12U
/** 31..0 watchdog: time without a valid command after which the drive goes off, us; 1 to
 * {card_watchdog_us}, any other means that. */
#define CARD_COMMAND_WATCHDOG 13U
/** 31..0 overspeed: counts a second above which the drive goes off; 0 for no limit. */
#define CARD_COMMAND_OVERSPEED 14U
/** 31..0 guard_minimum: least reading of the encoder, int32 counts; equal to the largest for no
 * guard. */
#define CARD_COMMAND_GUARD_MINIMUM 15U
/** 31..0 guard_maximum: largest reading, int32 counts; may be less than the least, across the wrap.
 */
#define CARD_COMMAND_GUARD_MAXIMUM 16U
/** 31..0 axis: number of the axis, for a display; 0xFFFFFFFF for none. */
#define CARD_COMMAND_AXIS 17U
/** 31..0 complement: of word 5; each bit inverted. */
#define CARD_COMMAND_COMPLEMENT 61U

/** 31..0 accepted: sequence of the last command that was accepted; 0 before the first. */
#define CARD_REPORT_ACCEPTED 2U
/** 31..0 heartbeat: grows by one each report; any, wraps. */
#define CARD_REPORT_HEARTBEAT 3U
/** 31..0 time: of the card when it read the encoder, us; any, wraps. */
#define CARD_REPORT_TIME 4U
/**
 * 31..24 type: of the card; a card type.
 * 23..0 firmware: major, minor and patch, 8 bits each; that of the robot's file.
 */
#define CARD_REPORT_IDENTITY 5U
/** 31..0 system: as the controller said it; word 4 of the last command that was accepted. */
#define CARD_REPORT_SYSTEM 6U
/** 31..0 status: of the card; bits of status, all others 0. */
#define CARD_REPORT_STATUS 7U
/**
 * 31..16 unused: not used; 0.
 * 15..8 limits: switches, debounced; bits of limits.
 * 7..0 limits_raw: switches as they are read; bits of limits.
 */
#define CARD_REPORT_LIMITS 9U
/** 31..0 encoder: the reading, int32 counts of four a period; wraps. */
#define CARD_REPORT_ENCODER 10U
/** 31..0 last_edge: card time of the newest edge, us; any, wraps. */
#define CARD_REPORT_LAST_EDGE 13U
/** 31..0 fourth_edge: card time of the edge four before that one, us; any, wraps. */
#define CARD_REPORT_FOURTH_EDGE 14U
/**
 * 31..16 edges: since the last report; 0 to 65535, saturates.
 * 15..0 illegal_edges: both lines changed at once, since the last report; 0 to 65535, saturates.
 */
#define CARD_REPORT_EDGES 15U
/**
 * 31..16 adc_1: what converter 1 reads; 0 to 65535.
 * 15..0 adc_2: converter 2; the same.
 */
#define CARD_REPORT_ADC 16U
/**
 * 31..16 adc_3: converter 3; 0 to 65535.
 * 15..0 adc_4: converter 4; the same.
 */
#define CARD_REPORT_ADC_3_4 17U
/**
 * 31..16 driver_temperature: of the driver, 0.1 degree Celsius; int16.
 * 15..0 motor_temperature: of the motor, 0.1 degree Celsius; int16.
 */
#define CARD_REPORT_TEMPERATURES 18U
/**
 * 31..16 supply: of the driver, mV; 0 to 65535, 0 while its power is taken.
 * 15..0 current: of the driver, mA; 0 to 65535.
 */
#define CARD_REPORT_SUPPLY 19U
/** 31..0 wave_1: as applied, laid out as words 6 to 9 of a command; 0 in all four without waves. */
#define CARD_REPORT_WAVES 20U
/** 31..0 shape_1: as word 7 of a command; the same. */
#define CARD_REPORT_WAVE_1_SHAPE 21U
/** 31..0 wave_2: as word 8 of a command; the same. */
#define CARD_REPORT_WAVE_2 22U
/** 31..0 shape_2: as word 9 of a command; the same. */
#define CARD_REPORT_WAVE_2_SHAPE 23U
/**
 * 31..28 mode: what the driver applies now; a drive mode.
 * 27..24 direction: as it applies it; 0 or 1, 0 when off.
 * 23..0 duty: of pwm, the magnitude without it, or that of the converter; 0 with waves.
 */
#define CARD_REPORT_APPLIED 24U
/** 31..0 refused: commands with damage since power-on; wraps. */
#define CARD_REPORT_CRC_ERRORS 25U
/** 31..0 gaps: commands out of sequence or after a gap since power-on; wraps. */
#define CARD_REPORT_GAPS 26U
/** 31..0 trips: of the watchdog since power-on; wraps. */
#define CARD_REPORT_TRIPS 27U
/** 31..0 uptime: since power-on, s; wraps. */
#define CARD_REPORT_UPTIME 28U

#endif
