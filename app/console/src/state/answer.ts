// SPDX-License-Identifier: Apache-2.0
// Answers of the server to a panel.
import { useEffect, useState } from "react";
import type { Problem, Shape } from "@interface";
import { refusalOf, type Address, type Method, type Page } from "./page";
import { fitted } from "../words/shape";

/** A question that is asked once is repeated so often until it is answered. */
export const RETRY_MS = 1000;

/** Null when there is no answer, or none that this page can read. */
export async function ask<Answer>(
  page: Page,
  address: Address,
  shape: Shape<Answer>,
): Promise<Answer | null> {
  try {
    const response = await page.request("GET", address);
    return response.ok ? fitted(await response.json(), shape, address) : null;
  } catch {
    return null;
  }
}

/** The answer to a change, or the reason of its refusal. */
export type Changed<Answer> = { answer: Answer } | { problem: string };

/** Changes by a route that is no act: the same change may be asked for again. */
export async function change<Answer>(
  page: Page,
  method: Method,
  address: Address,
  shape: Shape<Answer>,
  body?: object,
): Promise<Changed<Answer>> {
  try {
    const text = body === undefined ? undefined : JSON.stringify(body);
    const response = await page.request(method, address, text);
    const answer: unknown = await response.json();
    return response.ok
      ? { answer: fitted(answer, shape, address) }
      : { problem: refusalOf(answer as Partial<Problem>) };
  } catch {
    return { problem: "The server does not answer." };
  }
}

/**
 * The answer, asked for at once, again every so many ms, and when `cause` changes; null while it is not known. Without
 * `everyMs` it is asked for until it is there. The second one puts a newer answer in its place.
 *
 * @satisfies SWR-CON-060
 */
export function useAnswer<Answer>(
  page: Page,
  address: Address,
  shape: Shape<Answer>,
  everyMs: number | null,
  cause = "",
): [Answer | null, (answer: Answer) => void] {
  const [answer, setAnswer] = useState<Answer | null>(null);
  useEffect(() => {
    let isWanted = true;
    const end = () => {
      isWanted = false;
      clearInterval(timer);
    };
    const askNow = async () => {
      const given = await ask(page, address, shape);
      if (isWanted) {
        setAnswer(given);
        if (everyMs === null && given !== null) {
          end();
        }
      }
    };
    const timer = setInterval(() => void askNow(), everyMs ?? RETRY_MS);
    void askNow();
    return end;
  }, [page, address, shape, everyMs, cause]);
  return [answer, setAnswer];
}
