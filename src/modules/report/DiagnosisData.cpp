#include "report/DiagnosisData.hpp"

#include "estimation/ModelFile.hpp"
#include "io/JsonReader.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"
#include "report/ResultData.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

/// Similarity of the first candidates, the pairs that the captures cannot distinguish, and a sentence; null if the
/// diagnosis has none.
nlohmann::json aliasesData(const JsonCursor& diagnosis);

/// A curve of a joint's deflection over a driver, in degrees, with a model file that adds it as a custom effect to the
/// `suggested` ones, whose residual it is.
nlohmann::json curveJson(const JsonCursor& curve, const nlohmann::json& suggested);

/// The cells of the joint x driver map; empty if the diagnosis has none.
nlohmann::json mapJson(const JsonCursor& diagnosis);

/// All verdicts and candidate states, as diagnosis files name them.
const std::vector<std::string_view>& verdicts();
const std::vector<std::string_view>& candidateStates();

/// The verdict as a headline.
std::string verdictHeadline(const JsonCursor& diagnosis);

/// Name of the noise floor: with joint scatter if the last model needs it.
std::string noiseFloorName(const JsonCursor& diagnosis);

/// The figures behind the verdict: held-out error, false-alarm probability, lack of fit, scatter.
std::vector<Fact> diagnosisFacts(const JsonCursor& diagnosis);

/// Adds the data of a diagnosis's figures, except its candidates, in display units: captures of each pose, cameras,
/// similarity of the first candidates. Data missing in the file stay empty or null.
void addFiguresData(const JsonCursor& diagnosis, nlohmann::json& data);

/// Adds a candidate's added-variable plot, one point (pose or null, signature, residual) per pose, and its effect on
/// images. Data missing in the file are null. `figures`: from the other overload.
void addFiguresData(const JsonCursor& entry, const nlohmann::json& figures, nlohmann::json& candidate);

/// Adds the residuals of a diagnosis's models ("given", and "last" if something was added), in display units: per joint
/// the deflections that would explain them, and residuals within images; and the recorded drivers. Data missing in the
/// file stay empty or null. `data` must contain the images.
void addResidualViewsData(const JsonCursor& diagnosis, nlohmann::json& data);

using nlohmann::json;

namespace {

constexpr Range share{0, 1, ""};

/// Similarity matrix of the first candidates.
struct Aliases {
  std::vector<std::string> candidates;
  std::vector<std::vector<double>> alike;

  /// The most similar pair, of all candidates or of those with one given candidate.
  std::pair<std::size_t, std::size_t> closest(std::optional<std::size_t> with = {}) const {
    std::pair<std::size_t, std::size_t> best{0, 1};
    double most = -1;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      for (std::size_t j = 0; j < candidates.size(); ++j) {
        if ((with ? i == *with && j != i : i < j) && alike[i][j] > most) {
          most = alike[i][j];
          best = {i, j};
        }
      }
    }
    return best;
  }
};

/// The confusable pair that needs the most additional data.
std::string confusedSentence(const std::vector<JsonCursor>& confusable) {
  const auto times = [](const JsonCursor& pair) { return pair.at("timesTheData").number(anyNumber); };
  const JsonCursor& hardest =
      *std::max_element(confusable.begin(), confusable.end(),
                        [&](const JsonCursor& a, const JsonCursor& b) { return times(a) < times(b); });
  return fmt::format("These captures cannot tell {} from {} (correlation {:.4g}{}): {}.", hardest.at("taken").text(),
                     hardest.at("other").text(), hardest.at("correlation").number(share),
                     confusable.size() > 1 ? fmt::format("; the hardest of {} such pairs", confusable.size()) : "",
                     times(hardest) > 1
                         ? fmt::format("they would need {:.2g} times as much data of this kind, or poses "
                                       "in which the two differ more",
                                       times(hardest))
                         : "both happen to explain them almost as well; further captures will tell");
}

/// Summary of the matrix. `taken`: labels added to the model.
std::string aliasSentence(const Aliases& aliases, const std::vector<JsonCursor>& confusable,
                          const std::vector<std::string>& taken) {
  if (!confusable.empty()) {
    return confusedSentence(confusable);
  }
  if (aliases.candidates.size() < 2) {
    return {};
  }
  for (std::size_t i = 0; i < aliases.candidates.size(); ++i) {
    if (std::find(taken.begin(), taken.end(), aliases.candidates[i]) != taken.end()) {
      const std::size_t other = aliases.closest(i).second;
      return fmt::format("These captures tell {} from all others here; most alike is {} (correlation {:.4g}).",
                         aliases.candidates[i], aliases.candidates[other], aliases.alike[i][other]);
    }
  }
  const auto [one, other] = aliases.closest();
  const double most = aliases.alike[one][other];
  return fmt::format(
      "Most alike are {} and {} (correlation {:.4g}): were one of them there, these poses would {} which.",
      aliases.candidates[one], aliases.candidates[other], most, most > 0.9 ? "hardly tell" : "tell");
}

std::vector<std::string> textsOf(const JsonCursor& list) {
  std::vector<std::string> result;
  for (const JsonCursor& text : list.elements()) {
    result.push_back(text.text());
  }
  return result;
}

} // namespace

json aliasesData(const JsonCursor& diagnosis) {
  const auto matrix = diagnosis.find("aliases");
  if (!matrix) {
    return nullptr;
  }
  const std::vector<std::string> candidates = textsOf(matrix->at("candidates"));
  Aliases aliases{candidates, {}};
  for (const JsonCursor& row : matrix->at("correlations").elements()) {
    aliases.alike.push_back(row.numbers(candidates.size(), share, "one per candidate"));
  }
  if (aliases.alike.size() != candidates.size()) {
    matrix->at("correlations").refuse("one row per candidate");
  }
  const std::vector<JsonCursor> confusable = matrix->at("confusable").elements();
  json pairs = json::array();
  for (const JsonCursor& pair : confusable) {
    pairs.push_back({pair.at("taken").text(), pair.at("other").text()});
  }
  return {{"candidates", candidates},
          {"correlations", aliases.alike},
          {"confusable", pairs},
          {"sentence", aliasSentence(aliases, confusable, textsOf(diagnosis.at("suggested")))}};
}

using nlohmann::json;

namespace {

/// Unit of a driver by its name in expressions: "rad" for "q" and "LHipPitch", "Nm" for "tau_LHipPitch".
std::string driverUnit(const std::string& driver) {
  static const std::map<std::string, std::string> own{
      {"tau", "Nm"}, {"approach", "1"}, {"T", "°C"}, {"qd", "rad/s"}, {"t", "s"}};
  const auto known = own.find(driver);
  return known != own.end() ? known->second : driver.starts_with("tau_") ? "Nm" : "rad";
}

/// A model file with the curve's expression as a custom effect and the labels `with`.
json modelFile(const JsonCursor& effect, std::vector<std::string> with) {
  with.push_back(fmt::format("{}@{}", effect.at("name").text(), effect.at("at").text()));
  return modelFileJson(with, {}, json::array({effect.value()}));
}

} // namespace

json curveJson(const JsonCursor& curve, const json& suggested) {
  const std::string joint = curve.at("at").text(), driver = curve.at("driver").text();
  const auto about = curve.find("about");
  const auto valueUnit = curve.find("unit");
  const auto [shown, size] = displayUnit(valueUnit ? valueUnit->text() : "rad"); // unit of the curve's values
  const bool within = shown != "°"; // residual within images: board shape or lens, over places there
  const auto [unit, scale] = displayUnit(within ? (shown == "px" ? "px" : "m") : driverUnit(driver));
  const auto effect = curve.find("effect"); // only for joints' curves
  json points = json::array();
  for (const JsonCursor& point : curve.at("curve").elements()) {
    const std::vector<double> values = point.numbers(3, anyNumber, "driver, deflection, standard error");
    points.push_back({scale * values[0], size * values[1], size * values[2]});
  }
  if (points.size() < 2) {
    curve.at("curve").refuse("at least two points");
  }
  return {{"joint", joint},
          {"driver", driver},
          {"what", curve.at("what").text()},
          {"unit", unit},
          {"points", points},
          {"valueUnit", shown},
          {"amplitude", size * curve.at("amplitude").number(anyNumber)},
          {"evidence", curve.at("evidence").number(anyNumber)},
          {"expression", effect ? curve.at("expression").text() : ""},
          {"title", shown == "mm"   ? fmt::format("corners of board {} off along {}", joint, about->text())
                    : shown == "px" ? fmt::format("errors of camera {} along {}", joint, about->text())
                    : about         ? fmt::format("turn of camera {} about its {} axis", joint, about->text())
                                    : fmt::format("deflection of {}", joint)},
          {"model", effect ? modelFile(*effect, suggested.get<std::vector<std::string>>()) : json(nullptr)}};
}

json mapJson(const JsonCursor& diagnosis) {
  json cells = json::array();
  const auto map = diagnosis.find("map");
  for (const JsonCursor& cell : map ? map->elements() : std::vector<JsonCursor>{}) {
    const std::string joint = cell.at("at").text(), driver = cell.at("driver").text();
    cells.push_back({{"joint", joint},
                     {"driver", driver == "q"     ? joint
                                : driver == "tau" ? "tau_" + joint
                                                  : driver},
                     {"evidence", cell.at("evidence").number(anyNumber)},
                     {"pValue", cell.at("pValue").number({0, 1, ""})}});
  }
  return cells;
}

using nlohmann::json;

namespace {

/// A number; null if the diagnosis has none.
json numberOrNull(const JsonCursor& place, double scale = 1) {
  return place.value().is_null() ? json(nullptr) : json(scale * place.number(anyNumber));
}

json sizesJson(const JsonCursor& unknowns) {
  json sizes = json::array();
  for (const auto& [name, unknown] : unknowns.members()) {
    const auto [unit, scale] = displayUnit(unknown.at("unit").text());
    const auto told = unknown.find("told"); // absent in files of earlier versions
    sizes.push_back({{"name", name},
                     {"unit", unit},
                     {"told", !told || told->boolean()},
                     {"value", numberOrNull(unknown.at("value"), scale)},
                     {"sigma", numberOrNull(unknown.at("sigma"), scale)},
                     {"detectable", numberOrNull(unknown.at("minimalDetectable"), scale)}});
  }
  return sizes;
}

json candidateJson(const JsonCursor& entry, const json& figures) {
  const auto& states = candidateStates();
  const std::size_t state = entry.at("state").wordIndex(states);
  const auto why = entry.find("why");
  json result{{"label", entry.at("effect").text() + "@" + entry.at("at").text()},
              {"state", std::string{states[state]}},
              {"why", why ? why->text() : ""},
              {"sizes", sizesJson(entry.at("unknowns"))},
              {"power", numberOrNull(entry.at("power"))},
              {"kept", numberOrNull(entry.at("keptFraction"))},
              {"evidence", numberOrNull(entry.at("evidence"))},
              {"pValue", numberOrNull(entry.at("pValue"))},
              {"predictedDrop", numberOrNull(entry.at("predictedChi2Drop"))},
              {"realDrop", numberOrNull(entry.at("chi2Drop"))},
              {"before", numberOrNull(entry.at("heldOutPxBefore"))},
              {"after", numberOrNull(entry.at("heldOutPxAfter"))},
              {"step", entry.at("step").integer(0, maxInteger)},
              {"plausible", entry.at("plausible").boolean()},
              {"equivalent", entry.at("equivalent").texts()}};
  addFiguresData(entry, figures, result);
  return result;
}

json stepJson(const JsonCursor& step) {
  constexpr Range pixels{0, 1e9, "px"};
  const auto dropped = step.find("dropped");
  return {{"added", step.at("added").value().is_null() ? "" : step.at("added").text()},
          {"dropped", dropped ? json(dropped->texts()) : json::array()},
          {"rms", step.at("rmsPx").number(pixels)},
          {"heldOut", numberOrNull(step.at("heldOutPx"))},
          {"floor", step.at("noiseFloorPx").number(pixels)},
          {"alarm", step.at("alarm").number({0, 1, ""})}};
}

/// The reason of a suspicion, with its capture.
json suspicionJson(const JsonCursor& entry) {
  const std::string why = entry.at("why").text();
  const auto capture = entry.find("capture");
  const std::string name = capture ? fmt::format("capture {}", capture->integer(0, maxInteger)) : "";
  return why.find(name) != why.npos ? why : fmt::format("{} ({})", why, name);
}

} // namespace

json diagnosisData(const JsonCursor& diagnosis) {
  const auto defined = diagnosis.find("define");
  const bool own = defined && !defined->elements().empty(); // custom effect, last of the suggested ones
  json named = diagnosis.at("suggested").texts();
  if (own && !named.empty()) {
    named.erase(named.size() - 1);
  }
  json data{{"verdict", std::string{verdicts()[diagnosis.at("verdict").wordIndex(verdicts())]}},
            {"headline", verdictHeadline(diagnosis)},
            {"sentence", diagnosis.at("sentence").text()},
            {"floorName", noiseFloorName(diagnosis)},
            {"suggested", diagnosis.at("suggested").texts()},
            {"own", own},
            {"map", mapJson(diagnosis)}};
  addFiguresData(diagnosis, data);
  const auto list = [&](const char* key, const char* from, const auto& entryJson) {
    data[key] = json::array();
    for (const JsonCursor& entry : diagnosis.at(from).elements()) {
      data[key].push_back(entryJson(entry));
    }
  };
  list("steps", "steps", stepJson);
  list("candidates", "ranking", [&](const JsonCursor& entry) { return candidateJson(entry, data); });
  list("curves", "drivers", [&](const JsonCursor& curve) { return curveJson(curve, named); });
  list("suspicious", "suspicious", suspicionJson);
  const auto next = diagnosis.find("next");
  if (next && !next->value().is_null() && next->at("why").value() != "") { // otherwise nothing is open
    data["next"] = {{"poses", next->at("poses").elements().size()}, {"why", next->at("why").text()}};
  }
  data["facts"] = json::array();
  for (const auto& [figure, sentence] : diagnosisFacts(diagnosis)) {
    data["facts"].push_back({{"figure", figure}, {"sentence", sentence}});
  }
  return data;
}

namespace {

constexpr Range probability{0, 1, ""};
constexpr Range pixels{0, 1e9, "px"};

/// Joint scatter from pose to pose in the last model, 1 sigma [rad].
double scatterOf(const JsonCursor& diagnosis) {
  return diagnosis.at("poseScatter").number({0, 10, "rad"});
}

std::string chance(double p) {
  return p < 0.001 ? "p < 0.001" : fmt::format("p = {:.2g}", p);
}

Fact heldOutFact(const std::vector<JsonCursor>& all, const std::string& floor) {
  const std::string noise = fmt::format("{}: {:.2f} px", floor, all.back().at("noiseFloorPx").number(pixels));
  if (all.front().at("heldOutPx").value().is_null()) {
    return {fmt::format("{:.2f} px", all.front().at("rmsPx").number(pixels)),
            "error of the fit (of one pose: none is left to hold out); " + noise + "."};
  }
  const double before = all.front().at("heldOutPx").number(pixels), after = all.back().at("heldOutPx").number(pixels);
  if (all.size() == 1) {
    return {fmt::format("{:.2f} px", before), "held-out error: on poses that the fit has not seen; " + noise + "."};
  }
  return {fmt::format("{:.2f} → {:.2f} px", before, after),
          "held-out error: on poses that neither the fit nor the choice of effects has seen, before and after adding "
          "what is suggested; " +
              noise + "."};
}

/// `found`: the verdict is something other than a candidate, found by its own test.
Fact alarmFact(double alarm, bool found) {
  if (alarm <= 0.05) {
    return {chance(alarm), "is the chance that noise alone looks this convincing."};
  }
  return {chance(alarm), std::string{"is the chance that noise alone looks this convincing: "} +
                             (found ? "no reason to add a candidate. The finding above rests on a test of its own."
                                    : "no reason to add anything.")};
}

Fact lackOfFitFact(const JsonCursor& lackOfFit) {
  return {fmt::format("{:.2f}", lackOfFit.at("statistic").number({0, 1e15, ""})),
          "is the lack of fit of the first model, chi² per degree of freedom; noise alone gives 1."};
}

} // namespace

const std::vector<std::string_view>& verdicts() {
  static const std::vector<std::string_view> all{"adequate", "effect-missing", "unknown-effect",
                                                 "scatter",  "inconclusive",   "bad-captures"};
  return all;
}

const std::vector<std::string_view>& candidateStates() {
  static const std::vector<std::string_view> all{"present",      "aliased",  "trivial", "absent",
                                                 "inconclusive", "absorbed", "no-data"};
  return all;
}

std::string verdictHeadline(const JsonCursor& diagnosis) {
  static const std::vector<std::string> headlines{"The model explains these captures.",
                                                  "An effect is missing in the model.",
                                                  "Something that no known effect explains is at work.",
                                                  "Joints scatter at random.",
                                                  "Undecided: the model does not fit, but no single cause stands out.",
                                                  "Something is wrong with the captures or the set-up."};
  return headlines[diagnosis.at("verdict").wordIndex(verdicts())];
}

std::string noiseFloorName(const JsonCursor& diagnosis) {
  return scatterOf(diagnosis) > 0 ? "noise floor with joint scatter" : "noise floor";
}

std::vector<Fact> diagnosisFacts(const JsonCursor& diagnosis) {
  const std::vector<JsonCursor> steps = diagnosis.at("steps").elements();
  if (steps.empty()) { // no fit was possible
    return {};
  }
  const double scatter = scatterOf(diagnosis);
  std::vector<Fact> facts{
      heldOutFact(steps, noiseFloorName(diagnosis)),
      alarmFact(diagnosis.at("alarm").number(probability),
                diagnosis.at("verdict").text() == "unknown-effect" || diagnosis.at("verdict").text() == "bad-captures"),
      lackOfFitFact(diagnosis.at("lackOfFit"))};
  if (scatter > 0) {
    facts.push_back({fmt::format("{:.3f}°", degrees(scatter)),
                     "by which joints deflect at random from pose to pose (1 sigma) beyond what the model explains."});
  }
  return facts;
}

using nlohmann::json;

namespace {

std::vector<JsonCursor> elementsOf(const JsonCursor& object, const std::string& key) {
  const auto list = object.find(key);
  return list ? list->elements() : std::vector<JsonCursor>{};
}

/// Index of an entry in a list of the page.
int placeIn(const json& list, const JsonCursor& place) {
  return place.integer(0, static_cast<int>(list.size()) - 1);
}

/// Adds images (capture, camera, pose), poses (set, name, images) and cameras (width, height).
void addTaken(const JsonCursor& diagnosis, json& data) {
  data["pictures"] = data["poses"] = json::array();
  data["cameras"] = json::object();
  for (const JsonCursor& picture : elementsOf(diagnosis, "pictures")) {
    data["pictures"].push_back(
        {{"capture", picture.at("capture").integer(0, maxInteger)}, {"camera", picture.at("camera").text()}});
  }
  for (const JsonCursor& pose : elementsOf(diagnosis, "poses")) {
    json pictures = json::array();
    for (const JsonCursor& picture : pose.at("pictures").elements()) {
      pictures.push_back(placeIn(data["pictures"], picture));
      data["pictures"][pictures.back().get<std::size_t>()]["pose"] = data["poses"].size();
    }
    const JsonCursor name = pose.at("name");
    data["poses"].push_back({{"set", pose.at("set").text()},
                             {"name", name.value() == "" ? "–" : name.text()},
                             {"pictures", std::move(pictures)}});
  }
  if (const auto cameras = diagnosis.find("cameras")) {
    for (const auto& [name, camera] : cameras->members()) {
      data["cameras"][name] = {{"width", camera.at("width").integer(1, 100000)},
                               {"height", camera.at("height").integer(1, 100000)}};
    }
  }
}

json addedVariableData(const JsonCursor& candidate, const json& figures) {
  const auto view = candidate.find("addedVariable");
  if (!view) {
    return nullptr;
  }
  const auto [unit, scale] = displayUnit(view->at("unit").text());
  json points = json::array();
  for (const JsonCursor& point : view->at("points").elements()) {
    const JsonCursor pose = point.at("pose");
    points.push_back({pose.value().is_null() ? json(nullptr) : json(placeIn(figures["poses"], pose)),
                      point.at("signature").number(anyNumber) / scale, point.at("residual").number(anyNumber)});
  }
  return {{"of", view->at("of").text()},
          {"unit", unit},
          {"slope", scale * view->at("slope").number(anyNumber)},
          {"sigma", scale * view->at("sigma").number(anyNumber)},
          {"like", view->at("like").text()},
          {"points", points}};
}

json imprintData(const JsonCursor& candidate, const json& figures) {
  const auto view = candidate.find("imprint");
  if (!view) {
    return nullptr;
  }
  json sizes = json::array(), pictures = json::array();
  for (const auto& [name, size] : view->at("size").members()) {
    const auto [unit, scale] = displayUnit(size.at("unit").text());
    sizes.push_back({{"name", name}, {"value", scale * size.at("value").number(anyNumber)}, {"unit", unit}});
  }
  for (const JsonCursor& picture : view->at("pictures").elements()) {
    json corners = json::array();
    for (const JsonCursor& corner : picture.at("corners").elements()) {
      corners.push_back(corner.numbers(6, anyNumber, "u, v, shift before, shift after refitting"));
    }
    pictures.push_back({{"picture", placeIn(figures["pictures"], picture.at("picture"))},
                        {"before", picture.at("rmsPxBefore").number(anyNumber)},
                        {"after", picture.at("rmsPxAfter").number(anyNumber)},
                        {"corners", std::move(corners)}});
  }
  return {{"found", view->at("found").boolean()},
          {"sizes", std::move(sizes)},
          {"before", view->at("rmsPxBefore").number(anyNumber)},
          {"after", view->at("rmsPxAfter").number(anyNumber)},
          {"imitator", view->at("imitator").text()},
          {"pictures", std::move(pictures)}};
}

} // namespace

void addFiguresData(const JsonCursor& diagnosis, json& data) {
  addTaken(diagnosis, data);
  data["aliases"] = aliasesData(diagnosis);
  addResidualViewsData(diagnosis, data);
}

void addFiguresData(const JsonCursor& entry, const json& figures, json& candidate) {
  candidate["added"] = addedVariableData(entry, figures);
  candidate["imprint"] = imprintData(entry, figures);
}

using nlohmann::json;

namespace {

constexpr Range shiftPx{-1e9, 1e9, "px"};

std::size_t pictureAt(const JsonCursor& place, const json& data) {
  return static_cast<std::size_t>(place.integer(0, static_cast<int>(data["pictures"].size()) - 1));
}

/// A driver with its value at each image; `joint` if it can affect only that one.
json driverData(const JsonCursor& driver, std::size_t pictures) {
  const auto [unit, scale] = displayUnit(driver.at("unit").text());
  json values = json::array();
  for (const double value : driver.at("values").numbers(pictures, anyNumber, "one per picture")) {
    values.push_back(scale * value);
  }
  const auto joint = driver.find("at");
  return {{"what", driver.at("what").text()},
          {"unit", unit},
          {"joint", joint ? joint->text() : ""},
          {"values", std::move(values)}};
}

/// Per joint a list of (images, deflection and its standard error in degrees).
json whatIfData(const JsonCursor& list, const json& data) {
  json result = json::array();
  for (const JsonCursor& joint : list.elements()) {
    json points = json::array();
    for (const JsonCursor& point : joint.at("points").elements()) {
      json pictures = json::array();
      for (const JsonCursor& picture : point.at("pictures").elements()) {
        pictures.push_back(pictureAt(picture, data));
      }
      if (pictures.empty()) {
        point.at("pictures").refuse("at least one picture");
      }
      points.push_back({std::move(pictures), degrees(point.at("deflection").number(anyNumber)),
                        degrees(point.at("sigma").number(anyNumber))});
    }
    result.push_back({{"joint", joint.at("joint").text()}, {"points", std::move(points)}});
  }
  return result;
}

/// Cells (camera, u, v, du, dv, sigma, corners, worst image) and boards (image, board, distance, rms).
json withinData(const JsonCursor& within, const json& data) {
  json cells = json::array(), boards = json::array();
  for (const JsonCursor& cell : within.at("cells").elements()) {
    cells.push_back({{"camera", cell.at("camera").text()},
                     {"corners", cell.at("corners").integer(1, maxInteger)},
                     {"worst", pictureAt(cell.at("worstPicture"), data)}});
    for (const char* number : {"u", "v", "du", "dv", "sigma"}) {
      cells.back()[number] = cell.at(number).number(shiftPx);
    }
  }
  for (const JsonCursor& board : within.at("boards").elements()) {
    boards.push_back({{"picture", pictureAt(board.at("picture"), data)},
                      {"board", board.at("board").text()},
                      {"distance", board.at("distance").number({0, 1e6, "m"})},
                      {"rms", board.at("rmsPx").number(shiftPx)}});
  }
  return {{"noise", within.at("noisePx").number(shiftPx)}, {"cells", std::move(cells)}, {"boards", std::move(boards)}};
}

/// Boards (name, p) with corners (place and id, off and sigma in millimetres).
json shapeData(const JsonCursor& list) {
  constexpr Range metres{-1e3, 1e3, "m"};
  constexpr double millimetre = 1e-3;
  json result = json::array();
  for (const JsonCursor& shape : list.elements()) {
    json corners = json::array();
    for (const JsonCursor& corner : shape.at("corners").elements()) {
      json shown{{"id", corner.at("id").integer(0, maxInteger)},
                 {"place", corner.at("place").numbers(3, metres, "x, y and z")}};
      for (const char* name : {"off", "sigma"}) {
        for (const double value : corner.at(name).numbers(3, metres, "x, y and z")) {
          shown[name].push_back(value / millimetre);
        }
      }
      corners.push_back(std::move(shown));
    }
    result.push_back({{"board", shape.at("board").text()},
                      {"p", shape.at("p").number({0, 1, ""})},
                      {"corners", std::move(corners)}});
  }
  return result;
}

} // namespace

void addResidualViewsData(const JsonCursor& diagnosis, json& data) {
  data["drivers"] = json::array();
  data["left"] = json::object();
  if (const auto recorded = diagnosis.find("recorded")) {
    for (const JsonCursor& driver : recorded->elements()) {
      data["drivers"].push_back(driverData(driver, data["pictures"].size()));
    }
  }
  const auto left = diagnosis.find("left");
  for (const auto& [model, over] : left ? left->members() : std::vector<std::pair<std::string, JsonCursor>>{}) {
    data["left"][model] = {{"whatIf", whatIfData(over.at("whatIf"), data)},
                           {"within", withinData(over.at("withinPictures"), data)},
                           {"shapes", shapeData(over.at("boardShapes"))}};
  }
}

} // namespace naocal
