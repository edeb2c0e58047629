// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState, useSyncExternalStore } from "react";
import type { LoginRequest, Session } from "@interface";
import { isEnding, secondsLeft, type SessionStore } from "../../state/session";

function fieldOf(form: HTMLFormElement, name: string): string {
  const value = new FormData(form).get(name);
  return typeof value === "string" ? value : "";
}

function Form({
  way,
  onLogIn,
}: {
  way: Session["login"];
  onLogIn: (request: LoginRequest) => void;
}) {
  const submit = (form: HTMLFormElement) => {
    onLogIn(
      way === "code"
        ? { code: fieldOf(form, "code").trim().toUpperCase() }
        : { name: fieldOf(form, "name"), password: fieldOf(form, "password") },
    );
    // Name and code stay in the form to be corrected; the password does not stay in the page.
    const password = form.elements.namedItem("password");
    if (password instanceof HTMLInputElement) {
      password.value = "";
    }
  };
  return (
    <form
      className="login-form"
      onSubmit={(event) => {
        event.preventDefault();
        submit(event.currentTarget);
      }}
    >
      {way === "code" ? (
        <label>
          Code that Boresight printed at its start
          <input name="code" autoComplete="off" required />
        </label>
      ) : (
        <>
          <label>
            Name
            <input name="name" autoComplete="username" required />
          </label>
          <label>
            Password
            <input
              name="password"
              type="password"
              autoComplete="current-password"
              required
            />
          </label>
        </>
      )}
      <button type="submit">Log in</button>
    </form>
  );
}

function Warning({ session, onRenew }: { session: Session; onRenew(): void }) {
  const isLast = session.most_s <= session.idle_s;
  return (
    <p className="login-warning" role="alert">
      The session ends in {secondsLeft(session)} s.{" "}
      {isLast ? (
        "Log in again to go on."
      ) : (
        <button type="button" onClick={onRenew}>
          Stay logged in
        </button>
      )}
    </p>
  );
}

function Someone({
  session,
  store,
}: {
  session: Session;
  store: SessionStore;
}) {
  return (
    <>
      <p>
        Logged in as <strong>{session.name}</strong> (
        {session.role?.toLowerCase()})
      </p>
      <button type="button" onClick={() => void store.logOut()}>
        Log out
      </button>
      {isEnding(session) && (
        <Warning session={session} onRenew={() => void store.renew()} />
      )}
    </>
  );
}

function Nobody({ session, store }: { session: Session; store: SessionStore }) {
  const [isAsked, setAsked] = useState(false);
  if (session.login === "none") {
    return <p>Nobody can log in here.</p>;
  }
  return isAsked ? (
    <Form
      way={session.login}
      onLogIn={(request) => void store.logIn(request)}
    />
  ) : (
    <>
      <p>Not logged in</p>
      <button type="button" onClick={() => setAsked(true)}>
        Log in…
      </button>
    </>
  );
}

/**
 * The user who is logged in, and the way in and out.
 *
 * @satisfies SWR-SESS-010
 */
export function Login({ store }: { store: SessionStore }) {
  const { session, problem } = useSyncExternalStore(
    store.subscribe,
    store.getView,
  );
  useEffect(() => {
    store.start();
    return () => store.stop();
  }, [store]);
  if (session === null) {
    return null;
  }
  return (
    <section className="login" aria-label="Login">
      {session.is_open ? (
        <Someone session={session} store={store} />
      ) : (
        <Nobody session={session} store={store} />
      )}
      {problem !== null && (
        <p className="login-problem" role="alert">
          {problem}
        </p>
      )}
    </section>
  );
}
