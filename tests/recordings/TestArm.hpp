#pragma once

#include "recordings/ImportScene.hpp"
#include "robot/Urdf.hpp"

#include <string>

namespace naocal::testing {

/// An arm that turns, lifts, slides and grips (the grip mimics the slide), with a camera at its end.
inline const std::string armUrdf = R"(<robot name="arm">
  <link name="base"/><link name="upper"/><link name="fore"/><link name="slider"/><link name="finger"/><link name="flange"/><link name="eye"/>
  <joint name="shoulder_pan" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="3" effort="1"/></joint>
  <joint name="shoulder_lift" type="revolute"><parent link="upper"/><child link="fore"/><origin xyz="0.1 0 0"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" velocity="3" effort="1"/></joint>
  <joint name="slide" type="prismatic"><parent link="fore"/><child link="slider"/><origin xyz="0.4 0 0"/><axis xyz="1 0 0"/><limit lower="0" upper="0.3" velocity="1" effort="1"/></joint>
  <joint name="grip" type="revolute"><parent link="fore"/><child link="finger"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="1"/><mimic joint="slide"/></joint>
  <joint name="plate" type="fixed"><parent link="slider"/><child link="flange"/><origin xyz="0 0 0.05"/></joint>
  <joint name="mount" type="fixed"><parent link="flange"/><child link="eye"/><origin xyz="0 0 0.05"/></joint>
</robot>)";

inline ImportScene armScene() {
  ImportScene scene;
  scene.urdf = armUrdf;
  scene.robot = parseUrdf(armUrdf, "arm.urdf");
  scene.camera = "wrist";
  Board board;
  board.id = "A";
  board.link = "world";
  board.pattern = CharucoPattern{};
  board.points = innerCorners(*board.pattern);
  scene.boards = {board};
  return scene;
}

} // namespace naocal::testing
