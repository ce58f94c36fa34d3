#include "writer/machines/WorkcellWriting.hpp"

#include "seal/Seal.hpp"
#include "writer/Writing.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace blind {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

using nlohmann::json;

constexpr double timeOfFirst = 12.5; // [s]

json listOf(const VectorXd& values, double digits) {
  json entries = json::array();
  for (const double value : values) {
    entries.push_back(std::round(value * digits) / digits);
  }
  return entries;
}

json placementJson(const Transform& transform) {
  const Vector3d angles = rollPitchYaw(transform.turn);
  return {{"x", transform.shift.x()}, {"y", transform.shift.y()}, {"z", transform.shift.z()},
          {"roll", angles.x()},       {"pitch", angles.y()},      {"yaw", angles.z()}};
}

/// A placement to start from: off by centimetres and tenths of a radian.
json guessJson(const Transform& truth, RandomStream& chance) {
  std::array<double, 6> error{};
  for (std::size_t i = 0; i < error.size(); ++i) {
    error[i] = chance.uniformWithin(i < 3 ? 0.02 : 0.1);
  }
  return placementJson(truth * originTransform({error[0], error[1], error[2]}, {error[3], error[4], error[5]}));
}

/// Writes what the session measured, with noise, as naocal's capture set.
class WorkcellSetFile {
public:
  WorkcellSetFile(const WorkcellQuestion& question, RandomStream& noise)
      : question_{question}, cell_{question.cell}, plan_{question.plan}, noise_{noise} {}

  json set() {
    json file{{"format", "naocal-captures"},       {"version", 2},
              {"robot", {{"urdf", "robot.urdf"}}}, {"jointNames", json::array()},
              {"stances", {{{"id", 0}}}},          {"captures", json::array()}};
    for (const Machine::Joint& joint : question_.machine->joints) {
      file["jointNames"].push_back(joint.name);
    }
    addInstruments(file);
    addSteps(file);
    for (std::size_t i = 0; i < question_.session.size(); ++i) {
      file["captures"].push_back(capture(static_cast<int>(i)));
    }
    return file;
  }

private:
  void addInstruments(json& file);
  void addCamera(json& file);
  void addTracker(json& file) const;
  void addPlaces(json& file);
  void addSteps(json& file) const;
  json capture(int number);
  void addMeasured(const WorkcellReading& reading, bool bad, json& capture);
  json point(const Vector3d& value, double sigma);

  const WorkcellQuestion& question_;
  const Workcell& cell_;
  const WorkcellPlan& plan_;
  RandomStream& noise_;
};

void WorkcellSetFile::addInstruments(json& file) {
  if (const auto& sole = question_.machine->sole) {
    const std::string& foot = question_.machine->joints[sole->joint].link;
    file["stances"][0]["supportLinks"] = json::array({foot});
    file["soles"][foot] = placementJson(originTransform(sole->xyz, sole->rpy));
  }
  if (seesBoard(cell_.witness)) {
    addCamera(file);
    return;
  }
  if (cell_.witness == Witness::trackedFrame) {
    file["frames"] = json::array({{{"id", "tool"}, {"link", "hand"}}});
  } else {
    for (std::size_t i = 0; i < cell_.points.size(); ++i) {
      file["markers"].push_back(
          {{"id", fmt::format("m{}", i)}, {"link", "hand"}, {"pointGuess", {0, 0, 0.05}}, {"pointSigma", 0.1}});
    }
  }
  if (cell_.witness == Witness::touch) {
    addPlaces(file);
  } else {
    addTracker(file);
  }
}

void WorkcellSetFile::addCamera(json& file) {
  const bool carried = carriesCamera(cell_.witness);
  json lens{{"link", carried ? "hand" : "world"}, {"width", LensDistortion::width}, {"height", LensDistortion::height},
            {"fx", LensDistortion::focal},        {"fy", LensDistortion::focal},    {"cx", LensDistortion::cx},
            {"cy", LensDistortion::cy},           {"distortion", {0, 0, 0, 0, 0}}};
  if (plan_.mountUncertain) {
    lens["placementSigma"] = {{"x", mountSigma}, {"y", mountSigma}, {"z", mountSigma}};
  }
  if (!carried) {
    lens["placementGuess"] = guessJson(cell_.worldFromStand, noise_);
  }
  json board{{"id", "board"}, {"link", carried ? "world" : "hand"}, {"points", json::array()}};
  for (const Vector3d& corner : cell_.points) {
    board["points"].push_back(listOf(corner, 1e9));
  }
  if (cell_.witness == Witness::footAndHead) {
    board["link"] = "floor";
  } else {
    board["placementGuess"] = guessJson(carried ? cell_.worldFromStand : cell_.handFromTool, noise_);
  }
  file["cameras"]["camera"] = std::move(lens);
  file["boards"] = json::array({std::move(board)});
}

void WorkcellSetFile::addTracker(json& file) const {
  json tracker = json::object();
  if (plan_.sigmaTold) {
    tracker["sigma"] = plan_.sigma;
    if (cell_.witness == Witness::trackedFrame) {
      tracker["sigmaRotation"] = plan_.sigmaRotation;
    }
  }
  file["trackers"]["tracker"] = std::move(tracker);
}

void WorkcellSetFile::addPlaces(json& file) {
  for (std::size_t i = 0; i < cell_.places.size(); ++i) {
    file["places"].push_back({{"id", fmt::format("place{}", i)}});
  }
  const VectorXd distances = placeDistances(cell_);
  for (std::size_t i = 0; i < cell_.distances.size(); ++i) {
    const auto [first, second] = cell_.distances[i];
    file["distances"].push_back({{"between", {fmt::format("place{}", first), fmt::format("place{}", second)}},
                                 {"metres", distances[static_cast<Index>(i)] + noise_.normal(distanceSigma)},
                                 {"sigma", distanceSigma}});
  }
  if (plan_.sigmaTold) {
    file["contactSigma"] = plan_.sigma;
  }
}

void WorkcellSetFile::addSteps(json& file) const {
  const VectorXd scale = jointScale(*question_.machine);
  for (std::size_t i = 0; i < question_.machine->joints.size(); ++i) {
    const Machine::Joint& joint = question_.machine->joints[i];
    if (plan_.stepTold && plan_.encoderStep > 0) {
      file["encoderSteps"][joint.name] = plan_.encoderStep * scale[static_cast<Index>(i)];
    }
    if (plan_.slipStep > 0 && !joint.slides) {
      file["slipSteps"][joint.name] = plan_.slipStep;
    }
  }
}

json WorkcellSetFile::point(const Vector3d& value, double sigma) {
  return listOf(value + Vector3d{noise_.normal(sigma), noise_.normal(sigma), noise_.normal(sigma)}, 1e8);
}

/// `bad`: the reading is wrong by 20 to 50 standard deviations.
void WorkcellSetFile::addMeasured(const WorkcellReading& reading, bool bad, json& capture) {
  const MachineBody body = bodyOf(cell_);
  const VectorXd angles = linkAngles(cell_, reading);
  const double error = bad ? noise_.between(20, 50) * plan_.sigma : 0, way = noise_.uniformWithin(3.14);
  const Vector3d wrong{error * std::cos(way), error * std::sin(way), 0};
  if (cell_.witness == Witness::trackedFrame) {
    const Transform seen = standFromHand(cell_, body, reading, angles);
    const double sigma = plan_.sigmaRotation;
    Eigen::Quaterniond turn{
        seen.turn *
        originTransform(Vector3d::Zero(), {noise_.normal(sigma), noise_.normal(sigma), noise_.normal(sigma)}).turn};
    capture["frames"] = {{{"tracker", "tracker"},
                          {"frame", "tool"},
                          {"xyz", point(seen.shift + wrong, plan_.sigma)},
                          {"quaternion", {turn.w(), turn.x(), turn.y(), turn.z()}}}};
    return;
  }
  if (cell_.witness == Witness::touch) {
    capture["contacts"] = {{{"marker", "m0"}, {"place", fmt::format("place{}", reading.seen.front())}}};
    return;
  }
  const VectorXd measured = measure(cell_, body, reading, angles);
  if (cell_.witness == Witness::trackedPoints) {
    for (std::size_t i = 0; i < reading.seen.size(); ++i) {
      const Vector3d seen = measured.segment<3>(3 * static_cast<Index>(i)) + wrong;
      capture["points"].push_back(
          {{"tracker", "tracker"}, {"marker", fmt::format("m{}", reading.seen[i])}, {"xyz", point(seen, plan_.sigma)}});
    }
    return;
  }
  json ids = json::array(), uv = json::array();
  for (std::size_t i = 0; i < reading.seen.size(); ++i) {
    const Eigen::Vector2d seen = measured.segment<2>(2 * static_cast<Index>(i)) + wrong.head<2>() +
                                 Eigen::Vector2d{noise_.normal(plan_.sigma), noise_.normal(plan_.sigma)};
    if (seen.x() > 0 && seen.x() < LensDistortion::width && seen.y() > 0 && seen.y() < LensDistortion::height) {
      ids.push_back(reading.seen[i]); // the board may have moved out of the picture
      uv.push_back(listOf(seen, 1e4));
    }
  }
  capture["corners"] = {{{"board", "board"}, {"ids", ids}, {"uv", uv}}};
}

json WorkcellSetFile::capture(int number) {
  const WorkcellReading& reading = question_.session[static_cast<std::size_t>(number)];
  const bool bad = question_.badReading == static_cast<std::size_t>(number);
  VectorXd measured = reading.measured;
  VectorXd approach = reading.excursion.unaryExpr([](double from) { return from > 0 ? -1.0 : 1.0; });
  if (question_.reversed) {
    const auto joint = static_cast<Index>(*question_.reversed);
    measured[joint] = -measured[joint];
    approach[joint] = -approach[joint];
  }
  if (bad && cell_.witness == Witness::touch) { // a joint was read wrongly
    const double way = noise_.sign();
    measured[1] += way * noise_.between(0.01, 0.03);
  }
  json one{{"id", number},
           {"pose", fmt::format("P{:02}", reading.pose)},
           {"repeat", reading.repeat},
           {"repeatKind", reading.kind == RepeatKind::rest ? "rest" : "reapproach"},
           {"time", std::round((timeOfFirst + reading.time) * 1e4) / 1e4},
           {"stance", 0},
           {"joints", {{"measured", listOf(measured, 1e9)}, {"approach", listOf(approach, 1)}}}};
  if (seesBoard(cell_.witness)) {
    one["camera"] = "camera";
  }
  addMeasured(reading, bad, one);
  return one;
}

json truthJson(const WorkcellItem& item, const WorkcellQuestion& question, const std::string& name) {
  json truth{{"format", "naocal-blind-truth"},
             {"version", 1},
             {"set", name},
             {"machine", true},
             {"group", item.group},
             {"kind", item.kind},
             {"noise", nameOf(item.witness)},
             {"poses", item.poses},
             {"pictures", false},
             {"wanted", item.noncentrality},
             {"effects", json::array()},
             {"lockedFloorPx", 0},
             {"plan",
              {{"samples", question.plan.samples},
               {"sigma", question.plan.sigma},
               {"sigmaTold", question.plan.sigmaTold},
               {"encoderStep", question.plan.encoderStep},
               {"stepTold", question.plan.stepTold},
               {"scatter", question.plan.scatter}}}};
  for (std::size_t i = 0; i < question.machine->joints.size(); ++i) {
    truth["offsets"][question.machine->joints[i].name] = question.cell.offsets[static_cast<Index>(i)];
  }
  if (question.hidden) {
    json unknowns = json::object();
    for (std::size_t i = 0; i < question.hidden->values.size(); ++i) {
      const FlawFamily::Unknown& unknown = question.hidden->family->unknowns[i];
      unknowns[unknown.name] = {{"value", question.hidden->values[i]}, {"unit", unknown.unit}};
    }
    truth["effects"].push_back({{"effect", question.hidden->family->effect},
                                {"at", question.hidden->place},
                                {"unknowns", unknowns},
                                {"noncentrality", question.hidden->noncentrality},
                                {"kept", question.hidden->kept}});
  }
  if (const auto joint = question.reversed ? question.reversed : question.slipped) {
    truth["setUp"] = item.kind + "@" + question.machine->joints[*joint].name;
  }
  if (question.movedFrom) {
    const bool beside = item.witness == Witness::cameraBeside;
    const std::string what = carriesCamera(item.witness) ? "board" : beside ? "camera" : "tracker";
    const double after = question.session[*question.movedFrom].time;
    const double before = question.session[*question.movedFrom - 1].time;
    truth["event"] = {{"what", "moved " + what},
                      {"at", what},
                      {"before", before},
                      {"after", after},
                      {"by", placementJson(question.cell.moved->by)},
                      {"from", *question.movedFrom}};
  }
  if (question.badReading) {
    truth["badCapture"] = *question.badReading;
  }
  return truth;
}

} // namespace

void writeWorkcellItem(const WorkcellItem& item, std::uint64_t seed, int number, const std::filesystem::path& out) {
  const std::string name = setName(number), own = fmt::format("{} {}", seed, name);
  RandomStream chance{seed, own + " machine"}, noise{seed, own + " measurements"};
  const WorkcellQuestion question = drawWorkcellQuestion(item, chance);
  const json set = WorkcellSetFile{question, noise}.set();
  writeFile(out / "sets" / name / "robot.urdf", urdfText(*question.machine));
  writeFile(out / "sets" / name / "captures.json", set.dump() + "\n");
  sealTruth(truthJson(item, question, name).dump(1), false, seed, number, out);
}

} // namespace blind
