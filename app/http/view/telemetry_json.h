/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Snapshot, loop figures and events as JSON. Integers become mm and degrees here; the stream sends
 * the same objects that can be asked for one by one.
 */
#ifndef BORESIGHT_TELEMETRY_JSON_H
#define BORESIGHT_TELEMETRY_JSON_H

#include "common/log_entry.h"
#include "http/view/telemetry.h"

#include <cjson/cJSON.h>
#include <stdint.h>

#define TELEMETRY_JSON_BOOT_ID_SIZE 17U

/** The values that do not change while the server runs. */
typedef struct {
    char boot_id[TELEMETRY_JSON_BOOT_ID_SIZE]; /**< Another one for each start of the server. */
    const char *version;                       /**< Version of the program. */
    const char *build_id;                      /**< Build of the program. */
    const char *box; /**< Name of the simulated box, NULL for real cards. */
} telemetry_identity_t;

/**
 * The caller frees each result with cJSON_Delete(); NULL without memory.
 *
 * @satisfies SWR-DRIVE-014
 * @satisfies SWR-FORCE-579
 * @satisfies SWR-CON-062
 */
cJSON *telemetry_json_status(const telemetry_identity_t *identity, const telemetry_view_t *view);
/** @satisfies SWR-HTTP-037 */
cJSON *telemetry_json_robot(const telemetry_view_t *view);
cJSON *telemetry_json_motors(const telemetry_view_t *view);
/** @satisfies SWR-HTTP-006 */
cJSON *telemetry_json_targeting(const telemetry_view_t *view);
/** @satisfies SWR-IGTL-028 */
cJSON *telemetry_json_ports(const telemetry_view_t *view);

/** Name of a dialect of OpenIGTLink. */
const char *telemetry_json_dialect(uint32_t dialect);

/** @satisfies SWR-AUTH-017 */
cJSON *telemetry_json_authority(const telemetry_view_t *view);
cJSON *telemetry_json_event(const robot_t *robot, const log_entry_t *entry);

/** The state message of the stream: status, motors and targeting of one view. */
cJSON *telemetry_json_state(const telemetry_identity_t *identity, const telemetry_view_t *view);

#endif
