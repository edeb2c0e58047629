// SPDX-License-Identifier: Apache-2.0
// SCION, an interpreter of SCXML that others wrote. Answers each line of standard input, a step in JSON, with what the
// step came to.
//
// A request names the chart (its file), where to begin (before: leaves, history, armed, data; null starts the chart)
// and what happens: outside events in order, each an event name or [timer id, event name]. inputs holds one object of
// input values per run, and the answer one outcome per run. Time does not pass here: a delayed send arms its timer,
// and a timer's event comes when the request says so.

const readline = require("readline");
const scxml = require("@scion-scxml/scxml");

const silent = { log() {} };

// One run: the interpreter is restored, given the events and read.
class Run {
  constructor(model, before, inputs) {
    this.armed = new Set(before ? before.armed : []);
    this.started = new Set();
    this.raised = [];
    this.taken = [];
    this.queue = this.recordingQueue();
    this.statechart = new scxml.core.Statechart(
      model,
      this.options(before, inputs),
    );
    this.statechart.on("onTransition", (source, targets, index) =>
      this.taken.push([source, index]),
    );
  }

  options(before, inputs) {
    return {
      snapshot: before && [
        before.leaves,
        before.history,
        false,
        { ...before.data, ...inputs },
        this.queue,
      ],
      sessionRegistry: new Map(),
      console: silent,
      customSend: (event) => this.arm(event.sendid),
      customCancel: (id) => this.disarm(id),
    };
  }

  // SCION puts the outside event into the queue of raised ones as well; that one is no raise.
  recordingQueue() {
    const queue = [];
    queue.push = (event) => {
      if (event !== this.outside) this.raised.push(event.name);
      return Array.prototype.push.call(queue, event);
    };
    return queue;
  }

  arm(id) {
    this.armed.add(id);
    this.started.add(id);
  }

  disarm(id) {
    this.armed.delete(id);
    this.started.delete(id);
  }

  // A timer that an earlier expiry cancelled or started anew does not expire.
  expire(id, event) {
    if (!this.armed.has(id) || this.started.has(id)) return;
    this.armed.delete(id);
    this.take(event);
  }

  take(event) {
    this.outside = { name: event };
    this.statechart.gen(this.outside);
  }

  outcome() {
    const [leaves, history, , data] = this.statechart.getSnapshot();
    const { raised, taken } = this;
    return {
      leaves,
      history,
      data,
      armed: [...this.armed],
      started: [...this.started],
      raised,
      taken,
    };
  }
}

function outcome(model, request, inputs) {
  const run = new Run(model, request.before, inputs);
  if (!request.before) run.statechart.start();
  for (const event of request.events) {
    if (Array.isArray(event)) run.expire(...event);
    else run.take(event);
  }
  return run.outcome();
}

function load(file) {
  return new Promise((resolve, reject) => {
    scxml.pathToModel(file, (error, factory) => {
      if (error) reject(error);
      else
        factory.prepare((error, model) =>
          error ? reject(error) : resolve(model),
        );
    });
  });
}

async function serve() {
  const models = new Map();
  for await (const line of readline.createInterface({ input: process.stdin })) {
    const request = JSON.parse(line);
    if (!models.has(request.chart))
      models.set(request.chart, await load(request.chart));
    const outcomes = request.inputs.map((inputs) =>
      outcome(models.get(request.chart), request, inputs),
    );
    process.stdout.write(`${JSON.stringify(outcomes)}\n`);
  }
}

serve().catch((error) => {
  process.stderr.write(`scion: ${error.message || JSON.stringify(error)}\n`);
  process.exit(1);
});
