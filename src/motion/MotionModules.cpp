#include "motion/MotionModules.hpp"

#include "motion/CommandSender.hpp"
#include "motion/JointCalibrationProvider.hpp"
#include "motion/JointHistory.hpp"
#include "motion/PosePlayer.hpp"
#include "motion/SensorProvider.hpp"

#include <nlohmann/json.hpp> // to_json of the productions

namespace naocal {

void addMotionModules(Thread& motion, RobotInterface& robot, const Robot& drawing, ShutdownRequest& ending) {
  motion.add<SensorProvider>(robot);
  motion.add<JointCalibrationProvider>();
  motion.add<PosePlayer>(drawing, ending);
  motion.add<CommandSender>(robot, drawing);
  motion.add<JointHistory>();
}

} // namespace naocal
