// SPDX-License-Identifier: Apache-2.0
// What the server sends. Names and units are those of the interface, /api/v1.

export interface Named {
  name: string;
  text: string;
}

export interface Card {
  slot: number;
  axis: string;
  link: string;
  age_cycles: number;
  frame_errors: number;
  faults: string[];
}

/** How the board's time passes beside the world's. */
export interface Time {
  /** It waits for control: nothing can be late. */
  is_elastic: boolean;
  slowness: number;
  speed_percent: number;
}

export interface Loop {
  state: string;
  cycles: number;
  overruns: number;
  wake_p50_us: number;
  wake_p99_us: number;
  wake_p999_us: number;
  wake_worst_us: number;
  step_p99_us: number;
  step_worst_us: number;
  second_worst_us: number;
  rights: { fifo: boolean; core: boolean; memory: boolean };
}

export interface Status {
  cycle: number;
  /** Age of the snapshot when it was sent. */
  age_ms: number;
  boot_id: string;
  build_id: string;
  robot: string;
  /** Name of the simulated box; null with real cards. */
  box: string | null;
  workphase: Named;
  next_step: Named;
  order: string;
  pedal: string;
  estop: string;
  is_scanner_active: boolean;
  is_homed: boolean;
  is_registered: boolean;
  has_target: boolean;
  time: Time;
  loop: Loop;
  cards: Card[];
  counts: {
    events: number;
    events_lost: number;
    overruns: number;
    cycles_lost: number;
  };
  processes: { igtl: boolean; recorder: boolean };
}

export interface Permit {
  allowed: boolean;
  speed_cap_percent: number;
  since_ms: number;
  reasons: Named[];
}

/** Positions in `unit`, speed in `unit` per second. */
export interface Axis {
  name: string;
  unit: "mm" | "deg";
  position: number;
  setpoint: number;
  target: number;
  speed: number;
  minimum: number;
  maximum: number;
  position_ticks: number;
  setpoint_ticks: number;
  target_ticks: number;
  minimum_ticks: number;
  maximum_ticks: number;
  power: string;
  reference: string;
  stall: string;
  at_lower_switch: boolean;
  at_upper_switch: boolean;
  is_driven: boolean;
  permit: Permit;
}

export interface Motors {
  cycle: number;
  age_ms: number;
  axes: Axis[];
}

/** Matrices are homogeneous, by rows, in mm. */
export interface Targeting {
  cycle: number;
  age_ms: number;
  /** Null while an axis is not homed. */
  zframe_treatment: number[] | null;
  /** Null while an axis is not homed or nothing is registered. */
  scanner_treatment: number[] | null;
  registration: number[] | null;
  target: number[] | null;
  distance_mm: number | null;
  proposals: {
    registration: number[] | null;
    entry_mm: number[] | null;
    target_mm: number[] | null;
    is_reachable: boolean;
    desired: number[] | null;
  };
}

export interface LogEntry {
  number: number;
  cycle: number;
  name: string;
  text: string;
  severity: string;
  subject: string;
  value: number;
  /** What made it happen, in words at the end of `text`. */
  cause: string;
  peer: number;
}

/** The stream's `hello`. */
export interface Hello {
  boot_id: string;
  build_id: string;
}

/** The stream's `state`. */
export interface RobotState {
  status: Status;
  motors: Motors;
  targeting: Targeting;
}

/** The body of every refusal. */
export interface ErrorAnswer {
  code?: string;
  message?: string;
}
