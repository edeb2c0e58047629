/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/bench_levels.h"

#include "bsp.h"

void bench_levels_see(uint32_t inputs, uint32_t lamps, bsp_bench_t *seen)
{
    const uint32_t pedal = BSP_IN_PEDAL_A | BSP_IN_PEDAL_B;

    seen->is_pedal_pressed = (inputs & pedal) == pedal;
    seen->is_estop_pulled = (inputs & BSP_IN_ESTOP_CHAIN) == 0U;
    seen->is_scanner_active = (inputs & BSP_IN_SCANNER_IDLE) == 0U;
    seen->is_button_pressed = (inputs & BSP_IN_CONFIRM) != 0U;
    seen->is_lamp_alive = (lamps & BSP_LAMP_ALIVE) != 0U;
    seen->is_lamp_may_move = (lamps & BSP_LAMP_MAY_MOVE) != 0U;
    seen->is_lamp_moving = (lamps & BSP_LAMP_MOVING) != 0U;
    seen->is_lamp_fault = (lamps & BSP_LAMP_FAULT) != 0U;
}
