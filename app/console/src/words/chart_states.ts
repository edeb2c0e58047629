// SPDX-License-Identifier: Apache-2.0
// Which states of the charts are active, as the stream shows them, and how they have changed since a page looked.
import type { Chart, ChartName, ChartTransition } from "@charts";
import type { Axis, Card, RobotState } from "@interface";
import { words } from "./format";

/** The active leaf of each region. */
export type Leaves = Readonly<Record<string, string>>;

/** One of those that have a chart of their own: an axis, a card, or the robot. */
export interface Instance {
  name: string;
  leaves: Leaves;
}

const ofRobot = (state: string): Instance[] => [
  { name: "", leaves: { state } },
];

const ofAxes = (
  { motors }: RobotState,
  leaves: (axis: Axis) => Leaves,
): Instance[] =>
  motors.axes.map((axis) => ({ name: axis.name, leaves: leaves(axis) }));

const ofCards = (
  { status }: RobotState,
  leaves: (card: Card) => Leaves,
): Instance[] =>
  status.cards.map((card) => ({
    name: `slot ${card.slot}, ${card.axis ?? "no axis"}`,
    leaves: leaves(card),
  }));

/** A chart without a reader does not compile. */
export const readers: Readonly<
  Record<ChartName, (robot: RobotState) => Instance[]>
> = {
  arming: ({ status }) => ofRobot(status.order),
  authority: ({ status }) => ofRobot(status.authority.state),
  axis: (robot) =>
    ofAxes(robot, ({ power, reference }) => ({ power, reference })),
  card_link: (robot) => ofCards(robot, ({ link }) => ({ state: link })),
  estop_latch: ({ status }) => ofRobot(status.estop),
  loop_guard: ({ status }) => ofRobot(status.loop.state),
  pedal_gate: ({ status }) => ofRobot(status.pedal),
  stall_watchdog: (robot) => ofAxes(robot, ({ stall }) => ({ state: stall })),
  workphase: ({ status }) => ofRobot(status.workphase.name.toLowerCase()),
};

export interface Change {
  from: string;
  to: string;
  /** By the clock of the computer that shows the page. */
  at: Date;
}

/** The last state of each region of each instance, and its last change. */
export type Seen = Readonly<
  Record<string, { leaf: string; change: Change | null }>
>;

export function keyOf(chart: string, instance: string, region: string): string {
  return [chart, instance, region].join("/");
}

/** The same if nothing has changed. */
export function observe(seen: Seen, robot: RobotState, at: Date): Seen {
  const next = { ...seen };
  let isNew = false;
  for (const [chart, read] of Object.entries(readers)) {
    for (const { name, leaves } of read(robot)) {
      for (const [region, leaf] of Object.entries(leaves)) {
        const key = keyOf(chart, name, region);
        const last = seen[key];
        if (last?.leaf !== leaf) {
          const change = last ? { from: last.leaf, to: leaf, at } : null;
          next[key] = { leaf, change };
          isNew = true;
        }
      }
    }
  }
  return isNew ? next : seen;
}

/** The transitions that may have made it in one step; none if it took several. */
export function causesOf(
  chart: Chart,
  region: string,
  change: Change,
): readonly string[] {
  const { changes } = chart.regions.find(({ name }) => name === region) ?? {};
  return changes?.[`${change.from} ${change.to}`] ?? [];
}

/** A guard as people read it. */
function guardText(guard: string): string {
  const plain = guard
    .replaceAll(/In\('(\w+)'\)/g, "$1")
    .replaceAll(" && ", " and ")
    .replaceAll(" || ", " or ")
    .replaceAll(/!(?!=)/g, "not ")
    .replaceAll(/\bis_/g, "");
  return words(plain);
}

/** When it is taken. */
export function transitionText(
  id: string,
  transition: ChartTransition,
): string {
  const { events, guard } = transition;
  const on =
    events.length === 0 ? "at once" : `on ${events.map(words).join(" or ")}`;
  return guard === null
    ? `${id}, ${on}`
    : `${id}, ${on}, if ${guardText(guard)}`;
}

/** The drawing with these of its elements marked. */
export function marked(
  drawing: string,
  marks: Readonly<Record<string, readonly string[]>>,
): string {
  return Object.entries(marks).reduce(
    (all, [kind, ids]) =>
      ids.reduce(
        (text, id) =>
          text.replace(
            `<g id="${id}" class="`,
            `<g id="${id}" class="${kind} `,
          ),
        all,
      ),
    drawing,
  );
}
