// A simulated robot of this computer for tests: naocal-robot on UNIX sockets, with a configuration of its own.
import {cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync} from "node:fs";
import {spawn} from "node:child_process";
import {join} from "node:path";

export function robotIn(here, program, configuration, options = []) {
  cpSync(configuration, join(here, "configuration"), {recursive: true});
  const settings = join(here, "configuration/location/default/sdk.json");
  writeFileSync(settings, readFileSync(settings, "utf8").replace('"network.enableDebugTCPTransport": true', '"network.enableDebugTCPTransport": false')
    .replace('"local.unixSocketDirectory": ""', '"local.unixSocketDirectory": "' + join(here, "sockets/") + '"'));
  mkdirSync(join(here, "sockets"));
  let process_;
  return {
    // Its address, once it listens.
    async start() {
      process_ = spawn(program, ["--configuration", join(here, "configuration"), "--state", join(here, "state"), "--recordings", join(here, "recordings"), ...options], {stdio: "ignore"});
      process.on("exit", () => process_.kill("SIGKILL"));
      for (let i = 0; i < 300; ++i) {
        const name = readdirSync(join(here, "sockets")).find(one => existsSync(join(here, "sockets", one, "config")));
        if (name) return join(here, "sockets", name);
        await new Promise(resolve => setTimeout(resolve, 100));
      }
      throw new Error("the robot does not listen");
    },
    kill: () => process_.kill("SIGKILL"),
  };
}
