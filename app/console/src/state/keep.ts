// SPDX-License-Identifier: Apache-2.0
// Choices of the user, for the next time. A browser may refuse its storage; then it lasts as long as the page.

export function recall(key: string): string | null {
  try {
    return localStorage.getItem(`boresight-${key}`);
  } catch {
    return null;
  }
}

export function keep(key: string, value: string): void {
  try {
    localStorage.setItem(`boresight-${key}`, value);
  } catch {
    // It was only a convenience.
  }
}
