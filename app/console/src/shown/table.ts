// SPDX-License-Identifier: Apache-2.0
// shown.yml, and the fields that it must name.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { Play, ROOT, type Act, type Kept } from "./play";
import type { PageAct } from "./screen";

const TO_JSON =
  "puts JSON.generate(YAML.safe_load_file(ARGV[0], aliases: true))";

/** A scene, a reason why it never changes, or a test elsewhere that sees it change. */
export type Row =
  string | { constant: string } | { elsewhere: string; by: string };

export interface Scene {
  after: string;
  acts: PageAct[];
}

export interface Table {
  stages: Record<string, { robot?: string; after?: string; acts: Act[] }>;
  scenes: Record<string, Scene>;
  state: Record<string, Row>;
  /** By view; `everywhere` is seen in each. */
  page: Record<string, Record<string, Row>>;
}

interface Schema {
  $ref?: string;
  enum?: string[];
  anyOf?: Schema[];
  allOf?: Schema[];
  oneOf?: Schema[];
  items?: Schema;
  properties?: Record<string, Schema>;
  type?: string;
}

interface Document {
  components: { schemas: Record<string, Schema> };
}

export function readTable(): Table {
  const file = `${import.meta.dirname}/shown.yml`;
  const words = ["-ryaml", "-rjson", "-e", TO_JSON, file];
  return JSON.parse(execFileSync("ruby", words, { encoding: "utf8" })) as Table;
}

export function readRepository(path: string): string {
  return readFileSync(`${ROOT}/${path}`, "utf8");
}

function placesIn(schema: Schema, place: string, all: Document): string[] {
  const { $ref, anyOf, allOf, oneOf, items, properties } = schema;
  if ($ref !== undefined) {
    const named = all.components.schemas[$ref.split("/").at(-1) ?? ""];
    return placesIn(named ?? {}, place, all);
  }
  const parts = (anyOf ?? allOf ?? oneOf)?.filter(
    ({ type }) => type !== "null",
  );
  if (parts !== undefined) {
    return parts.flatMap((part) => placesIn(part, place, all));
  }
  if (items !== undefined) {
    return placesIn(items, `${place}[]`, all);
  }
  return properties === undefined
    ? [place]
    : Object.entries(properties).flatMap(([name, part]) =>
        placesIn(part, place === "" ? name : `${place}.${name}`, all),
      );
}

/**
 * Every field of the state that the server sends, as its OpenAPI document has it.
 *
 * @satisfies SWR-TOOL-030
 */
export function fieldsOfState(): string[] {
  const text = readRepository("build/gen/interface/app/openapi.json");
  const all = JSON.parse(text) as Document;
  return [...new Set(placesIn({ $ref: "/RobotState" }, "", all))];
}

/** The stages, each played once. */
export class Theatre {
  private readonly module = Play.module();
  private readonly table: Table;
  private readonly plays = new Map<string, Play>();
  private readonly kept = new Map<string, Kept>();

  constructor(table: Table) {
    this.table = table;
  }

  /** The robot as it is on that stage. */
  open(stage: string): Play {
    const play = this.playOf(stage);
    const kept = this.kept.get(stage);
    if (kept === undefined) {
      const { after, acts } = this.stageOf(stage);
      if (after !== undefined) {
        this.open(after);
      }
      play.doAll(acts);
      this.kept.set(stage, play.keep());
    } else {
      play.goBack(kept);
    }
    return play;
  }

  private stageOf(name: string) {
    const stage = this.table.stages[name];
    if (stage === undefined) {
      throw new Error(`There is no stage ${name}.`);
    }
    return stage;
  }

  private playOf(stage: string): Play {
    const { after, robot = "" } = this.stageOf(stage);
    if (after !== undefined) {
      return this.playOf(after);
    }
    const play = this.plays.get(stage) ?? new Play(this.module, robot);
    this.plays.set(stage, play);
    return play;
  }
}
