// SPDX-License-Identifier: Apache-2.0
// The tour: what it shows, in its order.

export interface TourStop {
  /** Selector of the element that is outlined; of several, the first. */
  selector: string;
  title: string;
  says: string;
}

export const stops: readonly TourStop[] = [
  {
    selector: ".banner .sign",
    title: "Does it move?",
    says: "One word: MOVING, MAY MOVE, ARMED (only the pedal is missing), STANDS, or what is wrong. The tab's title says the same.",
  },
  {
    selector: ".banner-text",
    title: "Why, and what next",
    says: "The cause that keeps the robot from moving, the next step, and the workphase.",
  },
  {
    selector: ".stop-button",
    title: "Stop",
    says: "Stops all motion at once, from every view; the Esc key does the same. Nobody has to be logged in for it. It is a software stop: the e-stop is on the robot.",
  },
  {
    selector: '.toolbar [aria-label="Login"]',
    title: "Log in",
    says: "Watching needs no login. To command, log in with the code that Boresight printed, or with your name, and take command. One page commands at a time.",
  },
  {
    selector: '[aria-label="System"]',
    title: "Lamps",
    says: "A grey circle: as usual. A blue diamond: in use. A triangle: look. An octagon: a fault. A bar: not there.",
  },
  {
    selector: ".views",
    title: "Views",
    says: "Procedure leads to the target. The others show the parts: motors, cards, connections, events.",
  },
  {
    selector: ".steps",
    title: "A procedure",
    says: "Its workphases in their order. A step that cannot be taken now says why. START UP homes the axes, while you hold the pedal.",
  },
  {
    selector: ".axes",
    title: "Axes",
    says: "Circle: where the axis shall be now. Diamond: where it is. Before an axis is homed its position is unknown, and the page says so.",
  },
  {
    selector: ".help-button",
    title: "Help",
    says: "Keys, every word used here, and this tour.",
  },
];
