// SPDX-License-Identifier: Apache-2.0
// Every word of this page that is not everybody's, once.

export interface Word {
  term: string;
  says: string;
}

export const glossary: readonly Word[] = [
  {
    term: "armed",
    says: "A motion has been commanded and is ready. It begins when the pedal is pressed, and stops when it is released.",
  },
  {
    term: "box, button at the box",
    says: "The control box between the computer and the robot, with the cards, the inputs for pedal and e-stop, and a button. Pressing the button gives command to the page that requests it, or confirms positions.",
  },
  {
    term: "calibration",
    says: "The workphase in which the registration is taken.",
  },
  {
    term: "card",
    says: "A card of the control box; each drives a motor and reads its encoder and limit switches. LIVE: it answers in time. LOST: it does not, and nothing moves by it.",
  },
  {
    term: "command, to take command",
    says: "The right to send the robot orders. One has it at a time: a page of the console, or a program that is connected by OpenIGTLink. Everybody can stop.",
  },
  {
    term: "control loop",
    says: "The program that computes each motor's next step a thousand times a second. LATE: it came too late. Late three times in a row, it stops everything.",
  },
  {
    term: "counted",
    says: "A position by the encoder alone, as from where the axis stood when it was switched on. Where it truly stands, nobody knows before it is homed or confirmed.",
  },
  {
    term: "data",
    says: "The age of the data on this page. LIVE: new within 0.3 s. STALE: nothing new for 0.7 s; the values shown are old.",
  },
  {
    term: "e-stop",
    says: "The button on the robot that cuts the drives by hardware. PULLED: it is active. LATCHED: it was, and START_UP is needed before anything moves again.",
  },
  {
    term: "entry point",
    says: "Where the needle shall go through the skin. It decides the direction and depth with which a target is reached.",
  },
  {
    term: "event",
    says: "Something that happened, with its time, how serious it is and what made it happen. The log keeps them.",
  },
  {
    term: "fault",
    says: "Trouble that was noticed by the robot itself. It stays until its cause is gone and START_UP is commanded.",
  },
  {
    term: "following error",
    says: "The distance by which an axis lags behind its set-point. Too large a distance is a fault.",
  },
  {
    term: "homing",
    says: "Each axis that has a limit switch goes to it, backs off and meets it again, slowly; from then on its position is known.",
  },
  {
    term: "limit switch",
    says: "A switch at an end of an axis. An axis that is on it moves only away from it.",
  },
  {
    term: "manual",
    says: "The workphase in which single axes are moved by hand of the operator, on this page.",
  },
  {
    term: "needle in",
    says: "The needle is, or may be, in the body. Nothing moves it sideways then.",
  },
  {
    term: "OpenIGTLink",
    says: "The network protocol by which navigation programs, such as 3D Slicer, exchange poses and commands with the robot.",
  },
  {
    term: "pedal",
    says: "The pedal lets the robot move, and only while it is pressed. RELEASE ONCE: the pedal must be seen released before it counts.",
  },
  {
    term: "permit",
    says: "The permission that an axis needs to be driven. It has reasons as long as it is not given, and each is shown.",
  },
  {
    term: "planning",
    says: "The workphase in which the target is chosen on images. Nothing moves.",
  },
  {
    term: "pose",
    says: "A place and a direction. Also a place with a name that the robot goes to: home, park, draping, egress.",
  },
  {
    term: "probe",
    says: "The instrument that the robot holds, the needle among it, with its lengths. All poses go by them.",
  },
  {
    term: "proposal",
    says: "A registration, entry point or target that a navigation program has sent. It decides nothing until somebody accepts it.",
  },
  {
    term: "recorder",
    says: "The program that writes down each cycle, so that what happened can be replayed.",
  },
  {
    term: "registration",
    says: "Where the robot stands in the scanner, as a matrix of 16 numbers. Without it no target can be reached.",
  },
  {
    term: "scanner",
    says: "The MRI scanner. While it acquires, the robot stands, so that the image is not disturbed.",
  },
  {
    term: "scanner coordinates",
    says: "Right, anterior, superior, in mm, as the scanner's images have them.",
  },
  {
    term: "set-point",
    says: "Where an axis shall be at this moment.",
  },
  {
    term: "simulated box",
    says: "A control box and robot that are computed, for trying things out. No real robot moves.",
  },
  {
    term: "soft limit",
    says: "The ends of an axis' range, as the robot's file has them. Nothing is commanded beyond.",
  },
  {
    term: "start up",
    says: "The workphase in which all axes are homed, and faults are cleared.",
  },
  {
    term: "stop",
    says: "The workphase after STOP. Nothing is armed; START_UP or another workphase goes on.",
  },
  {
    term: "taken in place",
    says: "The home of this axis was set where it stood; nothing has been measured.",
  },
  {
    term: "target",
    says: "The point that the needle's treatment point shall reach.",
  },
  {
    term: "targeting",
    says: "The workphase in which entry point and target are taken.",
  },
  {
    term: "time since start, at so many %",
    says: "The time for which control has run, by the clock of the box, and the pace of that clock. A simulated box can be slower than the world; its speeds in mm/s are of its own time.",
  },
  {
    term: "treatment point",
    says: "The point of the probe that treats, near its tip. Poses and targets are of this point.",
  },
  {
    term: "unverified, lost",
    says: "A position that was known, and is not to be relied on any more. Home the axis, or compare the position shown with the robot and confirm it.",
  },
  {
    term: "verified",
    says: "A position that was found by homing, or confirmed.",
  },
  {
    term: "workphase",
    says: "A step of the procedure: START_UP, PLANNING, CALIBRATION, TARGETING, MOVE_TO_TARGET; beside them MANUAL, STOP and EMERGENCY. It decides what may be commanded.",
  },
  {
    term: "z-frame",
    says: "The frame with bright rods that images show; by it the place of the robot in the scanner is found. Base coordinates are its.",
  },
];
