// Headless Chromium without network, driven through the DevTools protocol on two pipes.
// https://chromedevtools.github.io/devtools-protocol/

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export class Chromium {
  // `hosts` are numbers of hosts that it reaches all the same.
  constructor(program, hosts = []) {
    const rules = ["MAP * ~NOTFOUND", ...hosts.map((host) => `EXCLUDE ${host}`)].join(", ");
    this.profile = mkdtempSync(join(tmpdir(), "chromium-"));
    this.process = spawn(
      program,
      ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
        "--no-first-run", `--host-resolver-rules=${rules}`, `--user-data-dir=${this.profile}`, "--remote-debugging-pipe"],
      { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] },
    );
    this.answers = new Map();
    this.events = []; // {method, params} of all pages
    this.last = 0;
    this.pending = "";
    this.process.stdio[4].setEncoding("utf8").on("data", (text) => this.receive(text));
    this.process.on("exit", () => {
      for (const { reject } of this.answers.values()) reject(new Error("Chromium has ended"));
    });
  }

  receive(text) {
    const messages = (this.pending + text).split("\0");
    this.pending = messages.pop();
    for (const message of messages.map((m) => JSON.parse(m))) {
      if (message.id === undefined) {
        this.events.push(message);
        continue;
      }
      const { resolve, reject } = this.answers.get(message.id);
      this.answers.delete(message.id);
      if (message.error) reject(new Error(message.error.message));
      else resolve(message.result);
    }
  }

  send(method, params = {}, sessionId = undefined) {
    const id = ++this.last;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.answers.set(id, { resolve, reject }));
  }

  // A tab of such a size that has begun to load an address.
  async open(url, { width = 1280, height = 800, mobile = false } = {}) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const tab = new Tab(this, sessionId);
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await tab.send(`${domain}.enable`);
    await tab.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: mobile ? 2 : 1, mobile });
    await tab.send("Emulation.setTouchEmulationEnabled", { enabled: mobile });
    await tab.send("Page.navigate", { url });
    return tab;
  }

  async close() {
    await this.send("Browser.close").catch(() => {});
    await new Promise((resolve) => (this.process.exitCode === null ? this.process.on("exit", resolve) : resolve()));
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

class Tab {
  constructor(browser, session) {
    this.browser = browser;
    this.session = session;
  }
  send(method, params) {
    return this.browser.send(method, params, this.session);
  }
  events(method) {
    return this.browser.events.filter((event) => event.sessionId === this.session && event.method === method).map(({ params }) => params);
  }

  // The value of an expression in the page.
  async value(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, returnByValue: true, awaitPromise: true });
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description ?? exceptionDetails.text}`);
    return result.value;
  }

  // Waits until an expression in the page is true.
  async until(expression, seconds = 60) {
    const end = Date.now() + 1000 * seconds;
    while (!(await this.value(expression).catch(() => false))) {
      if (Date.now() > end) throw new Error(`not true after ${seconds} s: ${expression}`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  // What went wrong in the page, and what it has fetched besides itself and what is in it.
  complaints() {
    const said = this.events("Runtime.consoleAPICalled").filter(({ type }) => type === "error" || type === "warning" || type === "assert");
    return [
      ...this.events("Runtime.exceptionThrown").map((e) => e.exceptionDetails.exception?.description ?? e.exceptionDetails.text),
      ...said.map((e) => e.args.map((arg) => arg.value ?? arg.description).join(" ")),
      ...this.events("Log.entryAdded").map((e) => e.entry).filter((e) => e.level === "error").map((e) => e.text),
    ];
  }
  requests() {
    return this.events("Network.requestWillBeSent").map((e) => e.request.url).filter((url) => !/^(data|blob):/.test(url));
  }

  async screenshot() {
    const { data } = await this.send("Page.captureScreenshot", { format: "png" });
    return Buffer.from(data, "base64");
  }
}
