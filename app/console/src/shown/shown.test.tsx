// SPDX-License-Identifier: Apache-2.0
// Rule under test: each value in the state that the server sends and on the page is named in shown.yml with the scene that
// changes it, and is changed by it within 1.5 s of the robot's time. A value that would have changed without the scene is no
// witness. The server, the core and the simulated box are those of a page: build/site/served.wasm.
import { existsSync } from "node:fs";
import { afterAll, beforeAll, expect, test, vi } from "vitest";
import { views } from "../views/views";
import { ROOT, valuesAt, type Act } from "./play";
import { Screen, type PageAct } from "./screen";
import {
  fieldsOfState,
  readRepository,
  readTable,
  Theatre,
  type Row,
} from "./table";

/** The state is looked at so often after a scene, and the page. */
const STATE_LOOKS = [20, 80, 200, 700, 500];
const PAGE_LOOKS = [500, 500, 500];

const table = readTable();
const theatre = new Theatre(table);
const BANNER = readRepository("app/console/src/panels/shell/Banner.tsx");
const bannerParts = [
  ...new Set(BANNER.match(/(?<=className="[^"]*)\b(banner-|sign)[a-z-]*/g)),
];

/** Text at each name at a moment. */
type Look = ReadonlyMap<string, string>;

beforeAll(() => {
  vi.stubGlobal(
    "ResizeObserver",
    class {
      observe(): void {}
      disconnect(): void {}
    },
  );
  Screen.prepare();
});

afterAll(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

function sceneOf(name: string) {
  const scene = table.scenes[name];
  if (scene === undefined) {
    throw new Error(`There is no scene “${name}”.`);
  }
  return scene;
}

function scenesOf(rows: Record<string, Row>): Map<string, string[]> {
  const scenes = new Map<string, string[]>();
  for (const [name, row] of Object.entries(rows)) {
    if (typeof row === "string") {
      scenes.set(row, [...(scenes.get(row) ?? []), name]);
    }
  }
  return scenes;
}

/** The same time without what happens in it. */
function without(acts: readonly PageAct[]): PageAct[] {
  return acts.filter((act) => "wait" in act);
}

/** The names at which no look differs from the first one and from that of the other course. */
function unchanged(names: string[], looks: Look[], others: Look[]): string[] {
  const isOneCourse = looks === others;
  return names.filter((name) =>
    looks.every((look, at) => {
      const now = look.get(name);
      return (
        now === looks[0]?.get(name) ||
        (!isOneCourse && now === others[at]?.get(name))
      );
    }),
  );
}

const kept = new Map<string, Promise<Look[]>>();

function once(
  key: string,
  make: () => Look[] | Promise<Look[]>,
): Promise<Look[]> {
  const looks = kept.get(key) ?? Promise.resolve(make());
  kept.set(key, looks);
  return looks;
}

const fields = fieldsOfState();

function stateCourse(stage: string, acts: readonly PageAct[]): Look[] {
  const play = theatre.open(stage);
  const look = () => {
    const state = play.state();
    return new Map(
      fields.map((field) => [field, JSON.stringify(valuesAt(state, field))]),
    );
  };
  const looks = [look()];
  play.doAll(acts as readonly Act[]);
  for (const cycles of STATE_LOOKS) {
    play.step(cycles);
    looks.push(look());
  }
  return looks;
}

async function pageCourse(
  view: string,
  stage: string,
  acts: readonly PageAct[],
): Promise<Look[]> {
  const screen = new Screen(theatre.open(stage));
  try {
    await screen.open(view);
    const looks = [screen.read()];
    for (const act of acts) {
      await screen.do(act);
    }
    for (const ms of PAGE_LOOKS) {
      await screen.pass(ms);
      looks.push(screen.read());
    }
    return looks;
  } finally {
    screen.close();
  }
}

test("SWR-TOOL-030 every field of the state has a row, and every row has a field", () => {
  expect(Object.keys(table.state).sort()).toEqual(fields.sort());
});

test("SWR-TOOL-030 every part of the banner has a row", () => {
  const rows = Object.keys(table.page.everywhere ?? {});
  expect(bannerParts.length).toBeGreaterThan(8);
  for (const part of bannerParts) {
    expect(rows).toContain(`banner ${part}`);
  }
});

test("SWR-TOOL-030 what does not change says why, and what changes elsewhere is looked for there", () => {
  const rows = [table.state, ...Object.values(table.page)].flatMap((some) =>
    Object.entries(some),
  );
  for (const [name, row] of rows) {
    if (typeof row === "string") {
      expect(Object.keys(table.scenes), name).toContain(row);
    } else if ("constant" in row) {
      expect(row.constant, name).toMatch(/\.$/);
    } else {
      expect(existsSync(`${ROOT}/${row.elsewhere}`), row.elsewhere).toBe(true);
      expect(readRepository(row.elsewhere), name).toContain(row.by);
    }
  }
});

test.each([...scenesOf(table.state)])(
  "SWR-CON-098 of the state, %s: changes what its rows say within 1.5 s",
  async (name, rows) => {
    const { after, acts } = sceneOf(name);
    const rest = without(acts);
    const others = await once(JSON.stringify([after, rest]), () =>
      stateCourse(after, rest),
    );
    const looks = acts.length === 0 ? others : stateCourse(after, acts);
    expect(unchanged(rows, looks, others)).toEqual([]);
  },
);

/** Each view, and each scene that something on it is changed by. */
const pageScenes = views.flatMap(({ id }) => {
  const own = table.page[id] ?? {};
  // Values that each view has are looked at in the first one.
  const rows = id === views[0]?.id ? { ...table.page.everywhere, ...own } : own;
  return [...scenesOf(rows)].map(([scene, names]) => ({ id, scene, names }));
});

test.each(pageScenes)(
  "SWR-CON-098 on the page, view $id, $scene: changes what its rows say within 1.5 s",
  async ({ id, scene, names }) => {
    const { after, acts } = sceneOf(scene);
    const rest = without(acts);
    const others = await once(JSON.stringify([id, after, rest]), () =>
      pageCourse(id, after, rest),
    );
    const looks =
      acts.length === 0 ? others : await pageCourse(id, after, acts);
    expect(unchanged(names, looks, others)).toEqual([]);
    const known = { ...table.page.everywhere, ...table.page[id] };
    const seen = new Set(looks.flatMap((look) => [...look.keys()]));
    // SWR-TOOL-030: what is seen has a row.
    expect([...seen].filter((one) => !(one in known))).toEqual([]);
  },
);
