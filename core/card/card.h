/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the control box can hold: slots with daughter cards. Nothing here is of a robot. */
#ifndef BORESIGHT_CARD_H
#define BORESIGHT_CARD_H

#define CARD_SLOT_COUNT 10U    /**< Card slots of the control box. */
#define CARD_TYPES 6U          /**< Number of values of card_type_t. */
#define CARD_ADC_WORDS 2U      /**< Words of its converters in a report, two in each. */
#define CARD_EVERY_SLOT 0x3FFU /**< Their bits. */

/** Type of the card in a slot. */
typedef enum {
    CARD_TYPE_NONE = 0, /**< Nothing. */
    /** Speed by a duty word of 23 bits, of which its axis may use fewer. */
    CARD_TYPE_PWM = 1,
    /** Run or stop, and direction; some take a magnitude, too. */
    CARD_TYPE_NON_PWM = 2,
    /** Measures; has no motor, and refuses any drive but off. */
    CARD_TYPE_SENSOR = 3,
    /** Makes the two waves of the motor: speed by their frequency. */
    CARD_TYPE_HIGH_FREQUENCY = 4,
    /** Speed by a converter of 16 bits. */
    CARD_TYPE_ANALOG = 5
} card_type_t;

#endif
