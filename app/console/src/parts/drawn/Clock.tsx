// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "react";

const SECOND_MS = 1000;

/** By the clock of this machine; events have the server's. */
export function Clock() {
  const [now, setNow] = useState(() => new Date());
  useEffect(() => {
    const timer = setInterval(() => setNow(new Date()), SECOND_MS);
    return () => clearInterval(timer);
  }, []);
  return (
    <time className="utc" dateTime={now.toISOString()}>
      {now.toISOString().slice(11, 19)} UTC
    </time>
  );
}
