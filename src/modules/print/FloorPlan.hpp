#pragma once

#include "poses/PosePlan.hpp"
#include "print/PdfDocument.hpp"
#include "robot/Robot.hpp"

namespace naocal {

/// Adds pages with the floor of a plan, on A4 paper, to lay the boards by: outlines to scale, feet, distances from the
/// support sole's origin (below the ankle) in metres, a table of both upper corners of each board, and the poses with
/// what each observes. The robot faces up the page.
void addFloorPlan(PdfDocument& pdf, const PosePlan& plan, const Robot& robot);

} // namespace naocal
