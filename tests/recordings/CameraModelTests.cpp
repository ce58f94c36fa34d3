#include "recordings/CameraModelFile.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

CameraIntrinsics read(const std::string& text, const std::string& name = "lens.yaml") {
  const TemporaryDirectory folder;
  writeAtomically(folder.path() / name, text);
  return readCameraModel(folder.path() / name);
}

const std::string openCvYaml = R"(%YAML:1.0
---
calibration_time: "Fri"
image_width: 640
image_height: 480
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 600.5, 0., 321.25, 0., 601.5, 239.75, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ 0.1, -0.2, 0.001, 0.002, 0.03 ]
)";

const std::string openCvXml = R"(<?xml version="1.0"?>
<opencv_storage>
<image_width>640</image_width>
<image_height>480</image_height>
<cameraMatrix type_id="opencv-matrix"><rows>3</rows><cols>3</cols><dt>d</dt><data>600.5 0. 321.25 0. 601.5 239.75 0. 0. 1.</data></cameraMatrix>
<distCoeffs type_id="opencv-matrix"><rows>1</rows><cols>5</cols><dt>d</dt><data>0.1 -0.2 0.001 0.002 0.03</data></distCoeffs>
</opencv_storage>
)";

const std::string openCvJson = R"({
"image_width": 640,
"image_height": 480,
"K": {"type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d",
      "data": [ 600.5, 0.0, 321.25, 0.0, 601.5, 239.75, 0.0, 0.0, 1.0 ]},
"D": {"type_id": "opencv-matrix", "rows": 1, "cols": 5, "dt": "d", "data": [ 0.1, -0.2, 0.001, 0.002, 0.03 ]}
})";

const std::string ros = R"(image_width: 640
image_height: 480
camera_name: wrist
camera_matrix: {rows: 3, cols: 3, data: [600.5, 0, 321.25, 0, 601.5, 239.75, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0.1, -0.2, 0.001, 0.002, 0.03]}
)";

const std::string kalibr = R"(cam0:
  camera_model: pinhole
  intrinsics: [600.5, 601.5, 321.25, 239.75]
  distortion_model: radtan
  distortion_coeffs: [0.1, -0.2, 0.001, 0.002]
  resolution: [640, 480]
  rostopic: /cam
)";

const std::string mrcal = R"(# generated on 2026-01-01
{
    'lensmodel':  'LENSMODEL_OPENCV5',

    # intrinsics are fx,fy,cx,cy,distortion0,...
    'intrinsics': [ 600.5, 601.5, 321.25, 239.75, 0.1, -0.2, 0.001, 0.002, 0.03,],
    'valid_intrinsics_region': [
    [ 0, 0 ],
    [ 639, 0 ],
    ],
    'extrinsics': [ 0., 0., 0., 0., 0., 0.,],
    'imagersize': [ 640, 480,],
    'icam_intrinsics': 0,
}
)";

std::string with(std::string text, const std::string& part, const std::string& replacement) {
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), replacement);
}

} // namespace

TEST_CASE("a lens is the same from OpenCV's, ROS's, kalibr's and mrcal's files") {
  for (const std::string& text : {openCvYaml, openCvXml, openCvJson, ros, kalibr, mrcal}) {
    CAPTURE(text);
    const CameraIntrinsics lens = read(text);
    CHECK(lens.width == 640);
    CHECK(lens.height == 480);
    CHECK(lens.fx == 600.5);
    CHECK(lens.fy == 601.5);
    CHECK(lens.cx == 321.25);
    CHECK(lens.cy == 239.75);
    const double k3 = text == kalibr ? 0 : 0.03; // kalibr has none
    CHECK(lens.distortion == std::array<double, 5>{0.1, -0.2, 0.001, 0.002, k3});
  }
  const CameraIntrinsics pinhole =
      read(with(with(mrcal, "OPENCV5", "PINHOLE"), ", 0.1, -0.2, 0.001, 0.002, 0.03,", ""));
  CHECK(pinhole.distortion == std::array<double, 5>{});
  CHECK(read(with(with(mrcal, "OPENCV5", "OPENCV8"), "0.03,", "0.03, 0, 0, 0")).distortion[4] == 0.03);
}

TEST_CASE("other lens models and broken files are refused by name") {
  struct Broken {
    std::string text, sentence;
  };
  const std::vector<Broken> all{
      {with(mrcal, "OPENCV5", "SPLINED_STEREOGRAPHIC_order=3"), "LENSMODEL_SPLINED_STEREOGRAPHIC_order=3"},
      {with(mrcal, "OPENCV5", "OPENCV8"), "intrinsics"},
      {with(with(mrcal, "OPENCV5", "OPENCV8"), "0.03,", "0.03, 0, 0.5, 0"), "found coefficient 7 that is not 0"},
      {with(ros, "plumb_bob", "equidistant"), "equidistant"},
      {with(kalibr, "radtan", "equi"), "equi"},
      {with(kalibr, "pinhole", "omni"), "omni"},
      {kalibr + with(kalibr, "cam0", "cam1"), "a camchain of one camera"},
      {with(openCvYaml, "image_width: 640\n", ""), "expected image_width"},
      {with(openCvYaml, "600.5", ".Nan"), "line 10: camera_matrix.data[0]: expected a number, found \".Nan\""},
      {with(openCvYaml, "dt: d", ":dt d"), "expected valid YAML"},
      {with(openCvYaml, "dt: d", "dt: 3d"), "camera_matrix.dt: expected a type with one number per element"},
      {with(openCvYaml, "rows: 5", "rows: 6"), "distortion_coefficients.data: expected 6 numbers, found 5"},
      {with(openCvYaml, "640", "6.4e9"), "expected a picture's size of 1 to 100000 px"},
      {with(openCvYaml, "rows: 3", "rows: 1"), "camera_matrix.data: expected 3 numbers, found 9"},
      {with(openCvYaml, "600.5", "-600"), "expected a positive picture size and focal lengths"},
      {with(openCvXml, "</cameraMatrix>", ""), "expected XML, found an error there"},
      {with(openCvXml, "<rows>3", "<rows>2"), "cameraMatrix: expected rows x cols numbers, found 9"},
      {with(openCvXml, "<dt>d", "<dt>2d"), "cameraMatrix: expected a type (dt) with one number per element"},
      {with(openCvXml, "600.5", "wide"), "cameraMatrix: expected finite numbers, found \"wide 0. 321.25"},
      {with(openCvXml, "<data>0.1 -0.2 0.001 0.002 0.03</data>", ""), "distCoeffs: expected <data> with a value"},
      {with(openCvXml, "<image_width>640", "<image_width>"), "image_width: expected a number, found none"},
      {with(mrcal, "[ 640, 480,]", "[ 1e300, 480,]"), "imagersize[0]: expected a whole number from 1 to 100000"},
      {"hello: 1\n", "camera_matrix (ROS), cam0 (kalibr) or lensmodel (mrcal)"},
  };
  for (const Broken& broken : all) {
    CAPTURE(broken.text);
    CHECK_THROWS_WITH(read(broken.text), Catch::Contains(broken.sentence) && Catch::Contains("lens.yaml"));
  }
}
