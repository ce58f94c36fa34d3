// A simulated robot for tests: naocal-robot on UNIX sockets, with its own copy of the configuration.
import {cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync} from "node:fs";
import {spawn} from "node:child_process";
import {join} from "node:path";
import {until} from "./browser.mjs";

export function robotIn(here, program, configuration, options = []) {
  cpSync(configuration, join(here, "configuration"), {recursive: true});
  const settings = join(here, "configuration/location/default/sdk.json");
  writeFileSync(settings, readFileSync(settings, "utf8").replace('"network.enableDebugTCPTransport": true', '"network.enableDebugTCPTransport": false')
    .replace('"local.unixSocketDirectory": ""', '"local.unixSocketDirectory": "' + join(here, "sockets/") + '"'));
  mkdirSync(join(here, "sockets"));
  let process_;
  return {
    // Returns the address after the robot has started listening.
    async start() {
      process_ = spawn(program, ["--configuration", join(here, "configuration"), "--state", join(here, "state"), "--recordings", join(here, "recordings"), ...options], {stdio: "ignore"});
      process.on("exit", () => process_.kill("SIGKILL"));
      const listening = () => readdirSync(join(here, "sockets")).find(one => existsSync(join(here, "sockets", one, "config")));
      await until(() => process_.exitCode !== null || listening());
      if (!listening()) throw new Error("the robot does not listen");
      return join(here, "sockets", listening());
    },
    kill: () => process_.kill("SIGKILL"),
  };
}
