#include "Result.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <memory>

using namespace naocal;

namespace {

std::string outputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe{::popen(command.c_str(), "r"), ::pclose};
  std::string output;
  std::array<char, 65536> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) {
    output.append(buffer.data(), count);
  }
  return output;
}

} // namespace

TEST_CASE("a browser draws the whole report without complaint") {
  // Proves that the scripts run to their end, with hostile names too, and report no error. It does not prove that
  // the figures are beautiful.
  if (std::system("command -v chromium > /dev/null") != 0) {
    WARN("skipped: no chromium");
    return;
  }
  CalibratedFolder calibrated;
  for (nlohmann::json& sighting : calibrated.result["sightings"]) {
    sighting["pose"] = "<img src=x onerror=console.error('broken')>" + sighting["pose"].get<std::string>();
  }
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "report.html", calibrated.page());
  const std::string output = outputOf(fmt::format(
      "chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking --disable-component-update --disable-sync --user-data-dir={0}/profile "
      "--enable-logging=stderr --virtual-time-budget=2000 --window-size=400,900 --dump-dom file://{0}/report.html 2>&1",
      folder.path().string()));
  CHECK_THAT(output, Catch::Contains("<h1 id=\"headline\">This calibration can be used.</h1>"));
  CHECK_THAT(output, Catch::Contains("<option>LKneePitch</option>"));
  CHECK(occurrences(output, "<canvas") == 6 + 2 + 2 + 2); // pictures, cameras, poses and boards, angles and times
  CHECK(occurrences(output, "CONSOLE") == 0);
}
