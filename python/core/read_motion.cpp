#include <gapcheck/read_motion.hpp>
#include <span>
#include <string>
#include <vector>

#include "errors.hpp"
#include "module.hpp"
#include "options.hpp"
#include "record.hpp"

namespace gapcheck::python {
namespace {

/// T × n × 3 numbers of a Motion, as a view.
py::array states(const py::object& motion, std::vector<double> api::Motion::*member) {
  const auto& from = motion.cast<const api::Motion&>();
  const std::vector<double>& numbers = from.*member;
  const std::size_t nodes = from.node.size(), count = nodes == 0 ? 0 : numbers.size() / (3 * nodes);
  return view(std::span<const double>(numbers), motion, 3)
      .reshape({static_cast<py::ssize_t>(count), static_cast<py::ssize_t>(nodes), py::ssize_t{3}});
}

}  // namespace

void add_read_motion(py::module_& module) {
  using api::Motion;
  const auto list = [](auto Motion::*member, std::size_t columns) {
    return [member, columns](const py::object& self) {
      const auto& numbers = self.cast<const Motion&>().*member;
      return view(std::span(numbers.data(), numbers.size()), self, columns);
    };
  };
  Record<Motion>(module, "Motion", "Where n nodes are in T states of a d3plot, in the model's units.")
      .call("node", list(&Motion::node, 0), "n ids")
      .call("start", list(&Motion::start, 3), "n × 3, the mesh before the states")
      .call("times", list(&Motion::times, 0), "T")
      .call(
          "positions", [](const py::object& self) { return states(self, &Motion::positions); }, "T × n × 3")
      .call(
          "velocities", [](const py::object& self) { return states(self, &Motion::velocities); },
          "T × n × 3; 0 × n × 3: the file has none, or they were not asked for");
  module.def("read_motion", [](const py::object& path, const py::dict& options) {
    const std::string file = path_of(path);
    const Options given(options);
    api::MotionOptions settings;
    given.take("states", settings.states);
    given.take("velocities", settings.velocities);
    return worked([&] { return api::read_motion(file, settings); });
  });
}

}  // namespace gapcheck::python
