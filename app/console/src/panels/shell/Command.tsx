// SPDX-License-Identifier: Apache-2.0
import { useContext, useEffect, useSyncExternalStore } from "react";
import { commands, type Authority } from "@interface";
import type { PageAuthority } from "../../state/authority";
import { mayCommand, Stale, type Operation } from "../../state/operation";

function Mine({ own }: { own: PageAuthority }) {
  return (
    <>
      <p>
        <strong>This page commands.</strong>
      </p>
      <button type="button" onClick={own.giveUp}>
        {commands.RELEASE.label}
      </button>
    </>
  );
}

function Nobodys({ own }: { own: PageAuthority }) {
  return (
    <button type="button" onClick={() => void own.take()}>
      {commands.TAKE.label}
    </button>
  );
}

function Anothers({
  own,
  authority,
}: {
  own: PageAuthority;
  authority: Authority;
}) {
  return own.isAsking(authority) ? (
    <>
      <p>Release the pedal and press the button at the box.</p>
      <button type="button" onClick={own.giveUp}>
        Ask no more
      </button>
    </>
  ) : (
    <button type="button" onClick={() => void own.ask()}>
      Ask for command
    </button>
  );
}

function Way({ own, authority }: { own: PageAuthority; authority: Authority }) {
  if (useContext(Stale)) {
    return <p>The commanding client is not known.</p>;
  }
  if (own.isMine(authority)) {
    return <Mine own={own} />;
  }
  switch (authority.state) {
    case "nobody":
      return <Nobodys own={own} />;
    case "held":
      return <Anothers own={own} authority={authority} />;
    case "ending":
      return <p>Nobody commands before the axes rest.</p>;
  }
}

/**
 * The way to command, and out of it, for a user whose role allows it.
 *
 * @satisfies SWR-CON-014
 * @satisfies SWR-CON-061
 */
export function Command({
  operation,
  authority,
  speedup,
}: {
  operation: Operation;
  authority: Authority;
  speedup?: number;
}) {
  const { session, authority: own } = operation;
  const problem = useSyncExternalStore(own.subscribe, own.getProblem);
  const view = useSyncExternalStore(session.subscribe, session.getView);
  useEffect(() => {
    own.start();
    return () => own.stop();
  }, [own]);
  useEffect(() => own.notice(authority, speedup), [own, authority, speedup]);
  if (!mayCommand(view.session)) {
    return null;
  }
  return (
    <section className="login" aria-label="Command">
      <Way own={own} authority={authority} />
      {problem !== null && (
        <p className="login-problem" role="alert">
          {problem}
        </p>
      )}
    </section>
  );
}
