#include "residuals/Carried.hpp"

#include <map>

namespace naocal {

Eigen::VectorXd carried(const Model& from, const Eigen::VectorXd& unknowns, const Model& to) {
  std::map<std::string, double> values;
  const std::vector<std::string> names = from.names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    values[names[i]] = unknowns[static_cast<Eigen::Index>(i)];
  }
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(to.unknownCount()));
  const std::vector<std::string> wanted = to.names();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (const auto found = values.find(wanted[i]); found != values.end()) {
      result[static_cast<Eigen::Index>(i)] = found->second;
    }
  }
  return result;
}

} // namespace naocal
