#include "Result.hpp"

#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <tuple>

using namespace naocal;
using nlohmann::json;

namespace {

/// Decodes the %XX of an address.
std::string withoutEscapes(const std::string& address) {
  std::string text;
  for (std::size_t i = 0; i < address.size(); ++i) {
    if (address[i] == '%') {
      text += static_cast<char>(std::stoi(address.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      text += address[i];
    }
  }
  return text;
}

/// The sentence of the page's facts that contains the words.
std::string factWith(const std::string& words, const json& page) {
  for (const json& fact : page["facts"]) {
    if (const std::string sentence = fact["sentence"]; sentence.find(words) != std::string::npos) {
      return sentence;
    }
  }
  return {};
}

} // namespace

TEST_CASE("a report shows every corner of every picture as the result has it") {
  // Proves that no corner is lost, duplicated or moved in the page's data, for both kinds of errors. Drawing is tested
  // in the browser.
  const CalibratedFolder calibrated;
  const json pictures = shown(calibrated.page())["pictures"];
  std::map<std::tuple<int, std::string, int>, std::pair<json, std::size_t>> corners;
  std::size_t count = 0;
  for (const json& picture : pictures) {
    for (const json& board : picture["boards"]) {
      for (std::size_t i = 0; i < board["ids"].size(); ++i, ++count) {
        corners[{picture["capture"], board["board"], board["ids"][i]}] = {board, i};
      }
    }
  }
  REQUIRE(count == calibrated.result["corners"].get<std::size_t>());
  REQUIRE(corners.size() == count);
  for (const json& observation : calibrated.result["sightings"]) {
    for (std::size_t i = 0; i < observation["ids"].size(); ++i) {
      const auto& [board, place] = corners.at({observation["capture"], observation["board"], observation["ids"][i]});
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double measured = observation["measured"][i][axis];
        CHECK(board["measured"][2 * place + axis].get<double>() == Approx(measured).margin(0.051));
        CHECK(board["reported"][2 * place + axis].get<double>() ==
              Approx(observation["predicted"][i][axis].get<double>() - measured).margin(0.00051));
        CHECK(board["fitted"][2 * place + axis].get<double>() ==
              Approx(observation["fitted"][i][axis].get<double>() - measured).margin(0.00051));
      }
    }
  }
}

TEST_CASE("a report's pictures come worst first") {
  // Proves the order of pictures, by which photographs are kept.
  const CalibratedFolder calibrated;
  double last = 1e9;
  const json page = shown(calibrated.page());
  for (const json& picture : page["pictures"]) {
    double squares = 0, corners = 0;
    for (const json& board : picture["boards"]) {
      for (const json& error : board["reported"]) {
        squares += error.get<double>() * error.get<double>();
      }
      corners += static_cast<double>(board["ids"].size());
    }
    CHECK(squares / corners < last + 0.01);
    last = squares / corners;
  }
}

TEST_CASE("estimates are shown in degrees and millimetres with their standard error and 95 percent interval") {
  // Proves units, errors and intervals of joint offsets; of camera rotations only the order is tested.
  const CalibratedFolder calibrated;
  const json groups = shown(calibrated.page())["groups"];
  REQUIRE(groups.size() == 2);
  CHECK(groups[0]["title"] == "joint offset");
  CHECK(groups[0]["unit"] == "°");
  const json& unknown = calibrated.result["effects"][0]["unknowns"]["o"];
  const json& row = groups[0]["rows"][0];
  CHECK(row["name"] == calibrated.result["effects"][0]["at"]);
  const json& answer = unknown["averaged"]; // averaged over possibly missing effects
  CHECK(row["value"].get<double>() == Approx(degrees(answer["value"].get<double>())));
  CHECK(row["sigma"].get<double>() == Approx(degrees(answer["sigma"].get<double>())));
  CHECK(row["low"].get<double>() == Approx(degrees(answer["interval"][0].get<double>())));
  CHECK(row["high"].get<double>() == Approx(degrees(answer["interval"][1].get<double>())));
  CHECK(row["learned"] == unknown["learned"]);
  CHECK(groups[1]["rows"][0]["name"].get<std::string>().ends_with(" rx"));
}

TEST_CASE("the verdict is said in plain words") {
  // Proves the sentences for given numbers; the numbers are tested with the calibration.
  CalibratedFolder calibrated;
  const auto misfit = [&] { return factWith("is the noise floor", shown(calibrated.page())); };
  calibrated.result["sentence"] = "Usable, but a cause is missing: the error is 2 px: too much.";
  CHECK(shown(calibrated.page())["headline"] == "Usable, but a cause is missing.");
  CHECK(shown(calibrated.page())["sentence"] == "The error is 2 px: too much.");
  calibrated.result["pValue"] = 0.4;
  CHECK(misfit().find("no more striking than pure noise") != std::string::npos);
  calibrated.result["pValue"] = 0.01;
  CHECK(misfit().find("once in 100 calibrations") != std::string::npos);
  calibrated.result["pValue"] = 0.0;
  CHECK(misfit().find("less than once in 1000") != std::string::npos);
}

TEST_CASE("a report says of joints' noise only what was measured") {
  // Proves that encoders of unknown steps are not given a noise that nobody measured.
  CalibratedFolder calibrated;
  const auto noise = [&] { return factWith("encoders", shown(calibrated.page())); };
  calibrated.result["noise"]["source"] = "repeats";
  CHECK_THAT(noise(), Catch::Contains("; encoders 0.0") && Catch::EndsWith("taken more than once."));
  calibrated.result["noise"]["unknownSteps"] = true;
  CHECK_THAT(noise(), Catch::Contains("encoders' steps unknown") && Catch::EndsWith("from pose to pose."));
}

TEST_CASE("a report loads nothing from elsewhere") {
  // Proves that the page contains no external reference, and that its policy forbids loading.
  const std::string page = CalibratedFolder{}.page();
  for (const std::string reference : {"http:", "https:", "//www", "<link", "url(", "src="}) {
    INFO(reference);
    CHECK(occurrences(page, reference) == 0);
  }
  CHECK(occurrences(page, "@import") ==
        occurrences(page, "@import {")); // type imports in comments; those of style sheets have no {
  CHECK(occurrences(page, "default-src 'none'") == 1);
}

TEST_CASE("a page carries its scripts as their files have them") {
  // Proves that the import map contains every script of web/ unchanged, with its name appended, and an entry for each
  // import. Browser tests run them.
  const std::string page = CalibratedFolder{}.page(), before = "<script type=\"importmap\">";
  const std::size_t start = page.find(before) + before.size();
  const json imports = json::parse(page.substr(start, page.find("</script>", start) - start))["imports"];
  const std::filesystem::path web = std::filesystem::path{NAOCAL_SOURCE_DIR} / "src/modules/report/web";
  std::size_t scripts = 0;
  for (const char* folder : {"lib", "plots", "views", "pages"}) {
    for (const auto& file : std::filesystem::directory_iterator{web / folder}) {
      scripts += file.path().extension() == ".js" ? 1 : 0;
    }
  }
  REQUIRE(scripts > 20);
  CHECK(imports.size() == scripts);
  for (const auto& [name, address] : imports.items()) {
    INFO(name);
    const std::string text = withoutEscapes(address.get<std::string>());
    const std::string source = readFile(web / name.substr(std::string{"naocal/"}.size()));
    CHECK(text == "data:text/javascript;charset=utf-8," + source + "//# sourceURL=" + name + "\n");
    const std::string from = "} from \"";
    for (std::size_t at = source.find(from); at != source.npos; at = source.find(from, at + 1)) {
      const std::size_t first = at + from.size();
      const std::string imported = source.substr(first, source.find('"', first) - first);
      CHECK((imports.contains(imported) || imported == "naocal/lib/types.js")); // type imports, in comments
    }
  }
}

TEST_CASE("names cannot become part of the page's code") {
  // Proves that names of boards and poses can neither end a script nor fill a placeholder of the frame; that scripts
  // insert names as text is inferred from the absence of innerHTML.
  CalibratedFolder calibrated;
  const std::string harmless = calibrated.page();
  const std::string name = "</script><script>alert('{{style}}')</script><!-- \" \\ \xff";
  for (json& observation : calibrated.result["sightings"]) {
    observation["board"] = observation["pose"] = name;
  }
  calibrated.result["findings"].push_back({{"level", "note"}, {"why", name}, {"sentence", name}});
  writeAtomically(calibrated.resultFile(), calibrated.result.dump(-1, ' ', false, json::error_handler_t::replace));
  const std::string page = renderReport(calibrated.resultFile());
  for (const std::string code : {"<script", "</script", "<!--", "<style"}) {
    INFO(code);
    CHECK(occurrences(page, code) == occurrences(harmless, code));
  }
  CHECK(
      shown(page)["findings"].back()["sentence"].get<std::string>().starts_with("</script><script>alert('{{style}}')"));
  CHECK(occurrences(page, "innerHTML") + occurrences(page, "document.write") == 0);
}

TEST_CASE("a broken result file is refused with one sentence") {
  // Proves file and place in the message for a selection of faults.
  CalibratedFolder calibrated;
  const json good = calibrated.result;
  const auto refusal = [&](const std::string& pointer, const json& value) {
    calibrated.result = good;
    calibrated.result[json::json_pointer{pointer}] = value;
    try {
      calibrated.page();
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{"no refusal"};
  };
  CHECK_THAT(refusal("/format", "naocal-captures"),
             Catch::Contains("result.json: format: expected \"naocal-result\", \"naocal-diagnosis\" or"));
  CHECK_THAT(refusal("/version", 2), Catch::Contains("version"));
  CHECK_THAT(refusal("/sightings", json::array()),
             Catch::Contains("sightings: expected at least one board in a picture, or readings"));
  CHECK_THAT(refusal("/sightings/3/camera", "side"), Catch::Contains("expected the key \"side\""));
  CHECK_THAT(refusal("/sightings/3/ids", json::array()), Catch::Contains("sightings[3].ids"));
  CHECK_THAT(refusal("/sightings/3/predicted/0/1", nullptr), Catch::Contains("sightings[3].predicted[0][1]"));
  CHECK_THAT(refusal("/effects/0/unknowns/o/value", "much"), Catch::Contains("effects[0].unknowns.o.value"));
  CHECK_THAT(refusal("/noise", 3), Catch::Contains("noise: expected an object"));
  CHECK_THROWS_AS(renderReport(calibrated.captures() / "nothing.json"), InputError);
  writeAtomically(calibrated.resultFile(), "{\"format\":");
  CHECK_THROWS_AS(renderReport(calibrated.resultFile()), InputError);
}
