// A simulated robot for tests: naocal-robot on UNIX sockets, with its own copy of the configuration.
import {cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync} from "node:fs";
import {spawn} from "node:child_process";
import {join} from "node:path";
import {until} from "./browser.mjs";

// `simulation`: what it differs in from a simulated robot as it comes; its cameras take 10 pictures per second, not 30,
// which leave processors to other tests.
export function robotIn(here, program, configuration, simulation = {}) {
  cpSync(configuration, join(here, "configuration"), {recursive: true});
  const settings = join(here, "configuration/location/default/sdk.json");
  writeFileSync(settings, readFileSync(settings, "utf8").replace('"network.enableDebugTCPTransport": true', '"network.enableDebugTCPTransport": false')
    .replace('"local.unixSocketDirectory": ""', '"local.unixSocketDirectory": "' + join(here, "sockets/") + '"'));
  mkdirSync(join(here, "sockets"));
  writeFileSync(join(here, "simulation.json"), JSON.stringify({periodSeconds: 0.1, ...simulation}));
  let process_;
  return {
    // Returns the address after the robot has started listening.
    async start() {
      process_ = spawn(program, ["--configuration", join(here, "configuration"), "--state", join(here, "state"), "--recordings", join(here, "recordings"), "--simulation", join(here, "simulation.json")], {stdio: "ignore"});
      process.on("exit", () => process_.kill("SIGKILL"));
      const listening = () => readdirSync(join(here, "sockets")).find(one => existsSync(join(here, "sockets", one, "config")));
      await until(() => process_.exitCode !== null || listening());
      if (!listening()) throw new Error("the robot does not listen");
      return join(here, "sockets", listening());
    },
    kill: () => process_.kill("SIGKILL"),
  };
}
