// SPDX-License-Identifier: Apache-2.0
// Rule under test: the banner says the state and what is needed next, and never shows old data as new.
import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { Alarm, Authority, Needle } from "@interface";
import type { ConsoleView } from "../../state/store";
import { makeAuthority, makeBlockedAxis, makeRobot } from "../../testing/robot";
import { Banner } from "./Banner";

const live: ConsoleView = {
  isConnected: true,
  refusal: null,
  freshness: "live",
  ageMs: 0,
  isOutdated: false,
  robot: makeRobot(),
  log: [],
};

afterEach(cleanup);

test("SWR-CON-001 shows the sign, what is needed next, then the state", () => {
  render(<Banner view={live} />);
  expect(screen.getByRole("status").textContent).toBe(
    "MAY MOVEheadPress and hold the pedal.START UP The axes home.",
  );
});

test("SWR-SUP-012 says how many cycles are not recorded, and nothing without any", () => {
  const { counts } = makeRobot().status;
  const robot = makeRobot({ counts: { ...counts, unrecorded: 123 } });
  render(<Banner view={{ ...live, robot }} />);
  expect(screen.getByRole("status").textContent).toContain(
    "Not recorded: the last 123 cycles, as the recorder does not read them.",
  );
  cleanup();
  const failing = { ...robot.status, is_recorder_failing: true };
  render(<Banner view={{ ...live, robot: { ...robot, status: failing } }} />);
  expect(screen.getByRole("status").textContent).toContain(
    "Not recorded: the last 123 cycles, as the recorder cannot write them: free space on its disk",
  );
  cleanup();
  render(<Banner view={live} />);
  expect(screen.getByRole("status").textContent).not.toContain("recorded");
});

test("SWR-CON-001 waits for control without inventing a state", () => {
  render(<Banner view={{ ...live, robot: null }} />);
  expect(screen.getByRole("status").textContent).toContain(
    "Waiting for control",
  );
});

function shows(change: Partial<Authority>): string | null {
  const { container } = render(
    <Banner
      view={{ ...live, robot: makeRobot({ authority: makeAuthority(change) }) }}
    />,
  );
  return container.textContent;
}

const igtl: Partial<Authority> = {
  state: "held",
  source: "IGTL",
  peer: 11,
  name: "brp 127.0.0.1:53212",
  age_s: 12.9,
};

test("SWR-CON-012 says who commands, by name and for how long", () => {
  expect(shows(igtl)).toContain("Commanded by brp 127.0.0.1:53212 for 12 s");
});

test("SWR-CON-012 does not say that nobody commands where only the name is missing", () => {
  const said = shows({ ...igtl, name: null });
  expect(said).toContain("Commanded by somebody whose name is not known here");
  expect(said).not.toContain("Nobody");
});

test("SWR-CON-012 says that nobody commands while the axes come to rest", () => {
  expect(shows({ state: "ending" })).toContain(
    "Nobody commands before the axes rest",
  );
});

test.each([
  ["TAKE", "page of anna asks to command: release the pedal"],
  ["CONFIRM", "page of anna asks to confirm the positions shown"],
  ["CONFIRM_AXIS", "asks to confirm the position shown of head"],
] as const)(
  "SWR-CON-013 says who asks for the button to %s, and how long",
  (request, expected) => {
    const asked = {
      requester: "HTTP",
      requester_name: "page of anna",
      requester_peer: 7,
      left_s: 7.2,
    } as const;
    const text = shows({ ...igtl, ...asked, request });
    expect(text).toContain(expected);
    expect(text).toContain("8 s left");
  },
);

test("SWR-CON-012 announces nothing to readers of screens each second anew", () => {
  shows(igtl);
  expect(screen.getByRole("status").textContent).not.toContain("12 s");
});

test("SWR-CON-013 says nothing of the button without a request", () => {
  expect(shows(igtl)).not.toContain("button");
});

test("SWR-CON-049 names the axis and the card of the next step", () => {
  const next_step = { name: "CHECK_CARDS", text: "Check the card." } as const;
  const step_event = "CARD_LOST";
  const robot = makeRobot({
    next_step,
    step_axis: 0,
    step_card: 7,
    step_event,
  });
  render(<Banner view={{ ...live, robot }} />);
  expect(screen.getByRole("status").textContent).toContain(
    "Check the card. head, card 7: CARD LOST.",
  );
});

test.each([
  [
    3,
    [{ name: "KERNEL" as const, text: "" }],
    "3 times in 12 ms; this kernel is not a real-time kernel.",
  ],
  [1, [], "once in 12 ms."],
])("SWR-CON-090 names what was late %i times", (late_count, computer, ends) => {
  const next_step = { name: "START_UP", text: "Command START_UP." } as const;
  const { loop } = makeRobot().status;
  const stopped = {
    ...loop,
    state: "stopped" as const,
    late_us: 4100,
    late_span_us: 11600,
    late_count,
    computer,
  };
  render(
    <Banner
      view={{ ...live, robot: makeRobot({ next_step, loop: stopped }) }}
    />,
  );
  expect(screen.getByRole("status").textContent).toContain(
    `Command START_UP. Waking up was late by 4.1 ms, ${ends}`,
  );
});

test("SWR-CON-049 names nothing where the next step is of nothing", () => {
  render(<Banner view={live} />);
  expect(screen.getByRole("status").textContent).not.toContain("STARTED");
});

test.each([
  [false, "Log in to take command here"],
  [true, "Take command at the console"],
])("SWR-CON-050 says how to command (%s)", (mayCommand, expected) => {
  const next_step = {
    name: "AUTHORITY",
    text: "Take command at the console.",
  } as const;
  const robot = makeRobot({ next_step });
  render(<Banner view={{ ...live, robot }} mayCommand={mayCommand} />);
  expect(screen.getByRole("status").textContent).toContain(expected);
});

test("SWR-CON-004 says DATA STALE and how old it is", () => {
  render(<Banner view={{ ...live, freshness: "stale", ageMs: 3200 }} />);
  const text = screen.getByRole("alert").textContent;
  expect(text).toContain("DATA STALE");
  expect(text).toContain("3.2 s");
  expect(text).not.toContain("Press and hold the pedal.");
});

test("SWR-CON-004 says when the server cannot be reached", () => {
  const view: ConsoleView = { ...live, freshness: "stale", isConnected: false };
  render(<Banner view={view} />);
  expect(screen.getByRole("alert").textContent).toContain("cannot be reached");
});

test("SWR-CON-011 says why the server refuses the data", () => {
  const refused = {
    isConnected: false,
    refusal: "Too many consoles are open.",
  };
  render(<Banner view={{ ...live, ...refused, robot: null }} />);
  expect(screen.getByRole("status").textContent).toContain("Too many consoles");
  cleanup();
  render(<Banner view={{ ...live, ...refused, freshness: "stale" }} />);
  expect(screen.getByRole("alert").textContent).toContain("Too many consoles");
});

const lost: Alarm = {
  event: "CARD_LOST",
  reason: "LINK_LOST",
  axis: "insertion",
  is_over: false,
  subject: "3 (insertion)",
  text: "Card 3 (insertion) is lost. No frame of it came for several cycles.",
  since: "2026-11-22T17:50:00.123Z",
  age_s: 12.5,
};
const warm: Alarm = {
  ...lost,
  event: "CARD_UNWELL",
  reason: null,
  text: "Card 5 (yaw) is not well. Its driver is warm.",
  since: null,
  age_s: null,
};

test("SWR-CON-096 names the card that is why nothing moves, and lists what else is wrong, with since when", () => {
  const axis = makeBlockedAxis("head", { name: "LINK_LOST", text: lost.text });
  const robot = makeRobot({ alarms: [lost, warm] }, [axis]);
  const { container } = render(<Banner view={{ ...live, robot }} />);
  expect(container.querySelector(".banner-why")?.textContent).toBe(
    `${lost.text} Since 17:50:00 UTC.`,
  );
  expect(screen.getByRole("list", { name: "Alarms" }).textContent).toBe(
    `${warm.text} `,
  );
});

test("SWR-CON-096 lists all of them in their order when none of them is the reason that is reported", () => {
  const robot = makeRobot({ alarms: [warm, lost] });
  render(<Banner view={{ ...live, robot }} />);
  expect(
    screen.getAllByRole("listitem").map(({ textContent }) => textContent),
  ).toEqual([`${warm.text} `, `${lost.text} Since 17:50:00 UTC.`]);
});

function needleSaid(change: Partial<Needle>, alarms: Alarm[]): string | null {
  const needle = { ...makeRobot().status.needle, may_be_in: true, ...change };
  const robot = makeRobot({ needle, alarms });
  const { container } = render(<Banner view={{ ...live, robot }} />);
  const text = container.querySelector(".banner-needle")?.textContent ?? null;
  cleanup();
  return text;
}

test("SWR-CON-097 says after a fault where the needle was known last, how old that is, and that it may be in", () => {
  expect(
    needleSaid({ position: 35.2, age_s: 12.3, is_known: false }, [lost]),
  ).toBe(
    "The needle may be in the patient: insertion was last known at 35.20 mm, 12 s ago.",
  );
  expect(
    needleSaid({ position: null, age_s: null, is_known: false }, [lost]),
  ).toBe(
    "The needle may be in the patient: where insertion stands has not been known since the server started.",
  );
});

test("SWR-CON-097 says it under the e-stop too, where the position is known", () => {
  const pulled: Alarm = { ...lost, reason: "ESTOP_PULLED" };
  expect(needleSaid({ position: 35.2 }, [pulled])).toBe(
    "The needle may be in the patient: insertion stands at 35.20 mm.",
  );
});

test("SWR-CON-097 says nothing of a needle that is out, nor while nothing is wrong", () => {
  expect(needleSaid({ may_be_in: false }, [lost])).toBeNull();
  expect(needleSaid({}, [])).toBeNull();
  expect(needleSaid({}, [warm])).toBeNull();
});
