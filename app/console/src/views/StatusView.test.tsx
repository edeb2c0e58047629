// SPDX-License-Identifier: Apache-2.0
// Rule under test: each slot is shown with its finding, and each stage of the cycles with its duration.
import { cleanup, render, screen, within } from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import { barOf, className } from "../panels/procedure/Stages";
import { makeCommander } from "../testing/commander";
import { makeCard, makeRobot, makeViewProperties } from "../testing/robot";
import { StatusView } from "./StatusView";

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

async function show(status: Parameters<typeof makeRobot>[0] = {}) {
  const { operation } = await makeCommander("OBSERVER");
  render(<StatusView {...makeViewProperties(operation, makeRobot(status))} />);
  await screen.findByText("a78c5496");
}

function rowsOf(label: string) {
  const table = screen.getByRole("region", { name: label });
  return within(table).getAllByRole("row").slice(1);
}

test("SWR-CON-036 each slot is reported, and what was found there", async () => {
  await show({
    cards: [
      makeCard({ slot: 7, age_cycles: 12, frame_errors: 3, heartbeat: 4711 }),
      makeCard({
        slot: 9,
        axis: null,
        link: "lost",
        faults: ["too hot", "overspeed"],
        type: "high_frequency",
        converters: [1, 2, 3, 4],
      }),
    ],
  });
  const rows = rowsOf("Slots of the control box");
  expect(rows).toHaveLength(10);
  expect(rows[0]?.textContent).toBe("0nothing found");
  expect(rows[7]?.textContent).toBe(
    "7headnon pwmlive12 ms ago471130 0 0 0none",
  );
  expect(rows[9]?.textContent).toBe(
    "9nonehigh frequencylost0 ms ago100001 2 3 4too hot, overspeed",
  );
});

test("SWR-CON-036 a card that has said nothing shows no numbers of it", async () => {
  await show({
    cards: [
      makeCard({ slot: 2, link: "absent", type: "none", converters: [] }),
    ],
  });
  expect(rowsOf("Slots of the control box")[2]?.textContent).toBe(
    "2headnot heard yetabsent0none",
  );
});

test("SWR-CARD-014 what each card measures and counts of itself is reported, and what is wrong", async () => {
  await show({
    cards: [
      makeCard({
        slot: 9,
        axis: null,
        supply_mv: 18040,
        commands_damaged: 3,
        commands_out_of_order: 4,
        watchdog_trips: 1,
        troubles: [
          { name: "SUPPLY_LOW", text: "Its supply is low." },
          { name: "COMMANDS_REFUSED", text: "It refuses commands." },
        ],
      }),
      makeCard({ slot: 7, motor_temperature_dc: -15, current_ma: 350 }),
      makeCard({
        slot: 8,
        link: "lost",
        age_cycles: 20,
        watchdog_trips: 2,
      }),
      makeCard({ slot: 2, type: "none" }),
    ],
  });
  const rows = rowsOf("Health of the cards");
  expect(rows.map((row) => row.textContent)).toEqual([
    "7head33.1 °C\u22121.5 °C24.0 V350 mA000000nothing",
    "8head002000It is lost.",
    "9none33.1 °C25.0 °C18.0 V0 mA341000Its supply is low. It refuses commands.",
  ]);
  const levels = rows.map((row) =>
    row.lastElementChild?.getAttribute("data-level"),
  );
  expect(levels).toEqual(["normal", "attention", "attention"]);
});

test("SWR-LINK-041 what control discarded of a card and missed of it is reported by its reason", async () => {
  const counts = { frame_errors: 9, frames_out_of_order: 2, frames_missed: 5 };
  await show({ cards: [makeCard(counts)] });
  const cells = rowsOf("Health of the cards")[0]?.querySelectorAll("td");
  const texts = [...(cells ?? [])].map((cell) => cell.textContent);
  expect(texts.slice(8, 11)).toEqual(["7", "2", "5"]);
});

test("SWR-CON-036 each stage is reported by classes of time, and its longest", async () => {
  await show();
  const rows = rowsOf("Cycles by the time of each stage");
  expect(rows).toHaveLength(14);
  expect(rows[5]?.textContent).toBe("16–31 µs990990");
  expect(rows[13]?.textContent).toBe("Longest2345 µs2345 µs");
  const bars = rows[5]?.querySelectorAll("rect");
  expect(bars?.[0]?.getAttribute("width")).toBe("100%");
});

test("SWR-CON-036 classes are twice as wide as the one before", () => {
  const names = [0, 1, 2, 3, 11, 12].map((index) => className(index, 13));
  expect(names).toEqual([
    "0 µs",
    "1 µs",
    "2–3 µs",
    "4–7 µs",
    "1024–2047 µs",
    "from 2048 µs",
  ]);
});

test("SWR-CON-036 one cycle of many is still to be seen", () => {
  expect(barOf(0, 1e6)).toBe(0);
  expect(barOf(1, 1e6)).toBeGreaterThan(4);
  expect(barOf(1e6, 1e6)).toBe(100);
  expect(barOf(0, 0)).toBe(0);
});

test("SWR-CON-036 elastic time has no punctuality", async () => {
  const time = { is_elastic: true, slowness: 1, speedup: 1, speed_percent: 50 };
  await show({ time });
  expect(screen.queryByText("Longest")).toBeNull();
});

test("SWR-CON-036 it is reported what runs since when", async () => {
  await show({ cycle: 3_723_000, boot_id: "cafe", box: "bench" });
  const facts = screen
    .getAllByRole("definition")
    .map(({ textContent }) => textContent);
  expect(facts).toEqual(
    expect.arrayContaining([
      "2026-11-22 17:50:00.123",
      "1:02:03",
      "1.2.3, test",
      "neuro",
      "a78c5496",
      "simulated, bench",
      "cafe",
      "running",
      "0 / 0",
    ]),
  );
});

test("SWR-PACK-011 the versions that must fit together are reported", async () => {
  await show({
    version: "1.2.3",
    build_id: "0123456789ab",
    card_protocol: "7",
  });
  const reported = (term: string) =>
    screen.getByText(term).nextElementSibling?.textContent;
  expect(reported("Version and build")).toBe("1.2.3, 0123456789ab");
  expect(reported("Checksum of its file")).toBe("a78c5496");
  expect(reported("Protocol of the cards")).toBe("7");
  expect(screen.queryByText("Cards accepted by")).toBeNull();
});

test.each([
  ["A. Engineer, 2026-11-23", "A. Engineer, 2026-11-23"],
  ["", "nobody, nothing moves"],
])(
  "SWR-NI-019 of cards without protections it is reported on whose word: %s",
  async (accepted, expected) => {
    await show({ card_protocol: "aim32", cards_accepted: accepted });
    const reported = (term: string) =>
      screen.getByText(term).nextElementSibling?.textContent;
    expect(reported("Protocol of the cards")).toBe("aim32");
    expect(reported("Cards accepted by")).toBe(expected);
  },
);

test("SWR-CON-180 a card that was lost and answers is shown with what it measures", async () => {
  await show({ cards: [makeCard({ slot: 8, link: "lost", age_cycles: 0 })] });
  const text = rowsOf("Health of the cards")[0]?.textContent;
  expect(text).toContain("It was lost, and answers.");
  expect(text).toContain("°C");
});
