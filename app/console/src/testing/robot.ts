// SPDX-License-Identifier: Apache-2.0
// A robot for the tests, as the server would describe it.
import { Trace } from "../words/trace";
import type {
  Authority,
  Axis,
  Card,
  Force,
  LogEntry,
  Named,
  PermitReason,
  Port,
  RobotState,
  Role,
  Session,
  Stage,
  Status,
} from "@interface";
import type { Operation } from "../state/operation";
import type { ViewProperties } from "../views/view";

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export function makeAxis(name: string, change: Partial<Axis> = {}): Axis {
  return {
    name,
    unit: "mm",
    position: 10,
    setpoint: 12.5,
    target: 20,
    speed_per_s: 1,
    minimum: 0,
    maximum: 40,
    position_ticks: 100,
    setpoint_ticks: 125,
    target_ticks: 200,
    minimum_ticks: 0,
    maximum_ticks: 400,
    power: "enabled",
    reference: "verified",
    stall: "idle",
    at_lower_switch: false,
    at_upper_switch: false,
    is_driven: false,
    output_percent: 0,
    permit: {
      allowed: true,
      speed_cap_percent: 100,
      since_ms: 0,
      reasons: [],
    },
    ...change,
  };
}

/** An axis that may not move. */
export function makeBlockedAxis(
  name: string,
  ...reasons: Named<PermitReason>[]
): Axis {
  return makeAxis(name, {
    permit: {
      allowed: false,
      speed_cap_percent: 0,
      since_ms: 5000,
      reasons,
    },
  });
}

export function makePort(change: Partial<Port> = {}): Port {
  return {
    name: "workphases",
    dialect: "brp-2013",
    address: "127.0.0.1:18936",
    state: "listening",
    again_ms: 0,
    peers: 0,
    waiting: 0,
    troubles: 0,
    trouble: null,
    ...change,
  };
}

export function makeAuthority(change: Partial<Authority> = {}): Authority {
  return {
    state: "nobody",
    peer: 0,
    request: "NONE",
    request_axis: 0,
    requester_peer: 0,
    source: null,
    name: null,
    age_s: 0,
    requester: null,
    requester_name: null,
    left_s: 0,
    ...change,
  };
}

export function makeCard(change: Partial<Card> = {}): Card {
  return {
    slot: 7,
    axis: "head",
    link: "live",
    age_cycles: 0,
    frame_errors: 0,
    frames_out_of_order: 0,
    frames_missed: 0,
    heartbeat: 1000,
    driver_temperature_dc: 331,
    motor_temperature_dc: 250,
    supply_mv: 24000,
    current_ma: 0,
    commands_damaged: 0,
    commands_out_of_order: 0,
    watchdog_trips: 0,
    uptime_s: 60,
    troubles: [],
    faults: [],
    type: "non_pwm",
    converters: [0, 0, 0, 0],
    ...change,
  };
}

/** A channel of a force sensor that is believed. */
export function makeForce(change: Partial<Force> = {}): Force {
  return {
    channel: "HAND",
    force_mn: 0,
    reading: 1970,
    zero_mn: 0,
    noise_mn: 12,
    is_zeroing: false,
    doubts: [],
    ...change,
  };
}

/** Most of a thousand cycles took 16 to 31 us, and one was longer than the last class is wide. */
export function makeStage(name: Stage["name"]): Stage {
  return {
    name,
    says: `Stage ${name}.`,
    worst_us: 2345,
    counts: [0, 0, 0, 0, 9, 990, 0, 0, 0, 0, 0, 0, 1],
  };
}

export function makeStatus(change: Partial<Status> = {}): Status {
  return {
    cycle: 1000,
    age_ms: 0,
    utc: "2026-11-22T17:50:00.123Z",
    boot_id: "0011223344556677",
    version: "1.2.3",
    build_id: "test",
    robot: "neuro",
    card_protocol: "1",
    cards_accepted: null,
    box: null,
    workphase: { name: "START_UP", text: "The axes home." },
    authority: makeAuthority(),
    alarms: [],
    needle: {
      axis: "insertion",
      unit: "mm",
      position: 0,
      age_s: 0,
      is_known: true,
      may_be_in: false,
    },
    next_step: { name: "PRESS_PEDAL", text: "Press and hold the pedal." },
    step_axis: 10,
    step_card: 10,
    step_event: null,
    order: "waiting",
    mode: { name: "HOMING", text: "Every axis is homed." },
    done_per_mille: 0,
    left_ms: 0,
    pedal: "released",
    estop: "clear",
    is_scanner_active: false,
    unread_inputs: [],
    is_recorder_failing: false,
    recording_left_min: 0,
    is_homed: false,
    is_registered: false,
    ignores_registration_rotation: false,
    has_target: false,
    time: { is_elastic: false, slowness: 1, speedup: 1, speed_percent: 100 },
    loop: {
      state: "on_time",
      late_stage: { name: "WAKE", text: "Waking up." },
      late_us: 0,
      late_count: 0,
      late_span_us: 0,
      cycles: 1000,
      overruns: 0,
      wake_p50_us: 4,
      wake_p99_us: 20,
      wake_p999_us: 40,
      wake_worst_us: 90,
      step_p99_us: 20,
      step_worst_us: 40,
      second_worst_us: 30,
      minor_faults: 0,
      major_faults: 0,
      computer: [],
      stages: [makeStage("WAKE"), makeStage("STEP")],
      rights: { fifo: true, core: true, memory: true },
    },
    cards: [makeCard()],
    forces: [],
    counts: {
      events: 0,
      events_lost: 0,
      overruns: 0,
      cycles_lost: 0,
      unrecorded: 0,
    },
    processes: { igtl: true, recorder: true },
    ports: [makePort()],
    ...change,
  };
}

export function makeRobot(
  status: Partial<Status> = {},
  axes: Axis[] = [makeAxis("head")],
): RobotState {
  return {
    status: makeStatus(status),
    motors: { cycle: 1000, time_us: 1_000_000, age_ms: 0, axes },
    targeting: {
      cycle: 1000,
      age_ms: 0,
      zframe_treatment: identity,
      scanner_treatment: null,
      registration: null,
      target: null,
      entry_mm: null,
      seen_needle: null,
      steering_method: { name: "NONE", text: "" },
      steering_curvature_per_km: 0,
      steering_direction_deg: 0,
      steering_most_per_km: 0,
      is_rotation_awaited: false,
      distance_mm: null,
      has_probe: true,
      ignores_registration_rotation: false,
      registration_by: null,
      target_by: null,
      entry_by: null,
      probe: [
        {
          name: "needle_tip",
          length_mm: 259.075,
          minimum_mm: 150,
          maximum_mm: 350,
        },
      ],
      membranes: null,
      proposals: {
        registration: null,
        registration_by: null,
        entry_mm: null,
        entry_by: null,
        target_mm: null,
        target_by: null,
        is_reachable: false,
        desired: null,
      },
    },
  };
}

/** A user who is logged in. */
export function makeSession(role: Role): Session {
  return {
    is_open: true,
    name: "anna",
    role,
    token: "t0ken",
    idle_s: 900,
    most_s: 43_200,
    warn_s: 60,
    login: "none",
    boot_id: "boot",
  };
}

/** An event of the log. */
export function makeEntry(
  number: number,
  change: Partial<LogEntry> = {},
): LogEntry {
  return {
    number,
    cycle: 1000 * number,
    name: "STARTED",
    utc: "2026-11-22T17:50:00.123Z",
    text: `Event ${number}.`,
    severity: "INFORMATION",
    subject: "",
    value: 0,
    cause: "NONE",
    peer: 0,
    ...change,
  };
}

/** Properties of the views. */
export function makeViewProperties(
  operation: Operation,
  robot: RobotState,
  log: readonly LogEntry[] = [],
): ViewProperties {
  return {
    view: {
      isConnected: true,
      refusal: null,
      freshness: "live",
      ageMs: 20,
      isOutdated: false,
      robot,
      log,
    },
    robot,
    operation,
    outlook: null,
    trace: new Trace(),
  };
}
