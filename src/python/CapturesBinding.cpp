#include "python/Bindings.hpp"
#include "python/LongCall.hpp"
#include "python/SharedCaptures.hpp"
#include "python/Views.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "robot/Robot.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <fmt/format.h>
#include <limits>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <set>

namespace naocal {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

/// One capture of the sets.
struct CaptureHandle {
  SharedCaptures captures;
  const CaptureSet* set;
  const Capture* capture;
};

/// The corners of one board in one capture.
struct CornersHandle {
  SharedCaptures captures;
  const BoardCorners* corners;
};

std::vector<CaptureHandle> listCaptures(const SharedCaptures& captures) {
  std::vector<CaptureHandle> list;
  for (const CaptureSet& set : *captures->measurements.sets) {
    for (const Capture& capture : set.captures) {
      list.push_back({captures, &set, &capture});
    }
  }
  return list;
}

/// Measured angles, one row per capture and one column per joint of the robot [rad]; NaN where not recorded.
py::array_t<double> tabulateAngles(const SharedCaptures& captures) {
  const Robot& robot = captures->measurements.robot;
  const std::vector<CaptureHandle> list = listCaptures(captures);
  py::array_t<double> table({std::ssize(list), std::ssize(robot.joints)});
  auto cells = table.mutable_unchecked<2>();
  for (py::ssize_t row = 0; row < table.shape(0); ++row) {
    const auto& [owner, set, capture] = list[static_cast<std::size_t>(row)];
    for (py::ssize_t column = 0; column < table.shape(1); ++column) {
      cells(row, column) = std::numeric_limits<double>::quiet_NaN();
    }
    for (std::size_t i = 0; i < capture->joints.measured.size(); ++i) {
      if (const auto joint = robot.jointIndex(set->jointNames[i])) {
        cells(row, static_cast<py::ssize_t>(*joint)) = capture->joints.measured[i];
      }
    }
  }
  return table;
}

template <class Named> std::vector<std::string> namesOf(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) {
    names.push_back(one.name);
  }
  return names;
}

/// In alphabetical order.
std::vector<std::string> poseNames(const Captures& captures) {
  std::set<std::string> names;
  for (const PoseGroup& pose : captures.measurements.poses) {
    names.insert(pose.name);
  }
  return {names.begin(), names.end()};
}

std::string describe(const SharedCaptures& captures) {
  const Measurements& measurements = captures->measurements;
  return fmt::format("<naocal.Captures: {}, {} captures of {} poses, {} corners>", measurements.robot.model,
                     measurements.pictures.size(), measurements.poses.size(), measurements.cornerCount);
}

/// A view of a list of readings; None where nothing was recorded.
auto viewReadings(std::vector<double> JointReadings::*readings) {
  return [readings](const py::object& self) -> py::object {
    const std::vector<double>& numbers = self.cast<const CaptureHandle&>().capture->joints.*readings;
    return numbers.empty() ? py::object{py::none()} : viewOf(numbers, self);
  };
}

py::object listCorners(const CaptureHandle& handle) {
  if (!handle.capture->corners) {
    return py::none();
  }
  py::list list;
  for (const BoardCorners& corners : *handle.capture->corners) {
    list.append(CornersHandle{handle.captures, &corners});
  }
  return list;
}

void bindCorners(py::module_& module) {
  py::class_<CornersHandle>(module, "BoardCorners", "Corners of one board in one picture.")
      .def_property_readonly(
          "board", [](const CornersHandle& self) { return self.corners->board; }, "The board's id.")
      .def_property_readonly(
          "ids", [](const py::object& self) { return viewOf(self.cast<const CornersHandle&>().corners->ids, self); },
          "Numbers of the corners on the board, (n,) int32. A view.")
      .def_property_readonly(
          "uv", [](const py::object& self) { return viewOf(self.cast<const CornersHandle&>().corners->uv, self); },
          "Measured corners in the distorted picture [px], (n, 2). A view.")
      .def("__len__", [](const CornersHandle& self) { return self.corners->ids.size(); })
      .def("__repr__", [](const CornersHandle& self) {
        return fmt::format("<naocal.BoardCorners: {} of board {}>", self.corners->ids.size(), self.corners->board);
      });
}

void bindReadings(py::class_<CaptureHandle>& capture) {
  const std::tuple<const char*, std::vector<double> JointReadings::*, const char*> readings[] = {
      {"measured", &JointReadings::measured, "Raw encoder angles [rad], NaN where not recorded, (joints,). A view."},
      {"commanded", &JointReadings::commanded, "Commanded angles, without calibration [rad], (joints,). A view."},
      {"velocity", &JointReadings::velocity, "[rad/s], (joints,). A view."},
      {"approach", &JointReadings::approach, "Direction of the last motion: -1, 0 or +1, (joints,). A view."},
      {"temperature", &JointReadings::temperature, "[degC], (joints,). A view."},
      {"current", &JointReadings::current, "[A], (joints,). A view."}};
  for (const auto& [name, member, meaning] : readings) {
    capture.def_property_readonly(name, viewReadings(member), meaning);
  }
}

void bindCapture(py::module_& module) {
  py::class_<CaptureHandle> capture(module, "Capture",
                                    "One picture of a still robot by one camera. Lists of joints are in the order of "
                                    "`joint_names`, and None where the captures do not hold them.");
  capture
      .def_property_readonly(
          "set", [](const CaptureHandle& self) { return self.set->name; }, "Name of its set.")
      .def_property_readonly("id", [](const CaptureHandle& self) { return self.capture->id; })
      .def_property_readonly("pose", [](const CaptureHandle& self) { return self.capture->pose; })
      .def_property_readonly("repeat", [](const CaptureHandle& self) { return self.capture->repeat; })
      .def_property_readonly(
          "repeat_kind",
          [](const CaptureHandle& self) { return repeatKindWords[static_cast<std::size_t>(self.capture->repeatKind)]; },
          "'rest', 'reapproach' or 'restand'.")
      .def_property_readonly(
          "time", [](const CaptureHandle& self) { return self.capture->time.count(); }, "Middle of the exposure [s].")
      .def_property_readonly("camera", [](const CaptureHandle& self) { return self.capture->camera; })
      .def_property_readonly(
          "support_foot",
          [](const CaptureHandle& self) {
            return supportFootWords[static_cast<std::size_t>(self.capture->supportFoot)];
          },
          "'left', 'right', 'both' or 'none'.")
      .def_property_readonly("stance", [](const CaptureHandle& self) { return self.capture->stance; })
      .def_property_readonly(
          "image", [](const CaptureHandle& self) { return self.capture->image; },
          "The picture's file, relative to the set's folder; empty if it is not stored.")
      .def_property_readonly("joint_names", [](const CaptureHandle& self) { return self.set->jointNames; })
      .def_property_readonly("corners", listCorners,
                             "List of BoardCorners; None before 'naocal detect', empty if nothing was found.")
      .def("__repr__", [](const CaptureHandle& self) {
        return fmt::format("<naocal.Capture: {} of pose {}, camera {}>", self.capture->id, self.capture->pose,
                           self.capture->camera);
      });
  bindReadings(capture);
}

std::shared_ptr<Captures> readShared(const std::vector<std::filesystem::path>& folders,
                                     const std::optional<std::filesystem::path>& configuration, bool samePlace,
                                     bool skipBad) {
  return LongCall{}.run([&] {
    return std::make_shared<Captures>(
        readCaptures(folders, findConfiguration(configuration), {.samePlace = samePlace, .skipBad = skipBad}));
  });
}

} // namespace

std::filesystem::path findConfiguration(const std::optional<std::filesystem::path>& given) {
  if (given) {
    return *given;
  }
  Dl_info self;
  if (std::getenv("NAOCAL_CONFIGURATION") == nullptr && dladdr(reinterpret_cast<void*>(&findConfiguration), &self)) {
    // PREFIX/lib/python3/dist-packages/naocal/_naocal.so
    const auto folder = std::filesystem::absolute(self.dli_fname).parent_path();
    const auto installed = (folder / "../../../../share/naocal/configuration").lexically_normal();
    if (std::filesystem::is_directory(installed)) {
      return installed;
    }
  }
  return configurationDirectory();
}

SharedCaptures parseCaptures(const std::string& text, const std::string& name, const Robot& robot) {
  Captures captures;
  captures.sources = {{name}, {sha256(text)}};
  captures.measurements = buildMeasurements({parseCaptureSet(text, name).set}, robot);
  return std::make_shared<const Captures>(std::move(captures));
}

void bindCaptures(py::module_& module) {
  bindCorners(module);
  bindCapture(module);
  py::class_<Captures, std::shared_ptr<Captures>>(module, "Captures",
                                                  "Capture sets of one robot. A sequence of Capture; never changes.")
      .def_property_readonly(
          "robot", [](const Captures& self) { return self.measurements.robot.model; },
          "The robot's model, such as 'V6'.")
      .def_property_readonly(
          "joints", [](const Captures& self) { return namesOf(self.measurements.robot.joints); },
          "Names of the robot's joints: the columns of `joint_angles`.")
      .def_property_readonly(
          "sets", [](const Captures& self) { return self.sources.sets; }, "Folders of the sets.")
      .def_property_readonly(
          "boards", [](const Captures& self) { return namesOf(self.measurements.targets); }, "Names of the boards.")
      .def_property_readonly("poses", poseNames, "Names of the poses.")
      .def_property_readonly("corner_count", [](const Captures& self) { return self.measurements.cornerCount; })
      .def_property_readonly(
          "skipped", [](const Captures& self) { return self.skipped; },
          "One sentence per capture that was left out (`skip_bad`).")
      .def_property_readonly(
          "joint_angles", [](const std::shared_ptr<Captures>& self) { return tabulateAngles(self); },
          "Raw encoder angles [rad], (captures, joints), NaN where not recorded. A copy: captures do not lie together.")
      .def("__len__", [](const std::shared_ptr<Captures>& self) { return listCaptures(self).size(); })
      .def(
          "__getitem__",
          [](const std::shared_ptr<Captures>& self, py::ssize_t index) {
            std::vector<CaptureHandle> list = listCaptures(self);
            index += index < 0 ? std::ssize(list) : 0;
            if (index < 0 || index >= std::ssize(list)) {
              throw py::index_error{fmt::format("expected an index below {} captures", list.size())};
            }
            return list[static_cast<std::size_t>(index)];
          },
          "index"_a)
      .def("__iter__", [](const std::shared_ptr<Captures>& self) { return py::iter(py::cast(listCaptures(self))); })
      .def("__repr__", [](const std::shared_ptr<Captures>& self) { return describe(self); });
  module.def("read_captures", readShared, "folders"_a, "configuration"_a, "same_place"_a, "skip_bad"_a);
}

} // namespace naocal
