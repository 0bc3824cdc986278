#include "model/model.hpp"

#include <fmt/format.h>

namespace gapcheck::model {

bool Model::rigid(PartIndex index) const {
  if (index == none<PartIndex>) return false;
  const Part& part = parts[index.value];
  return part.material && materials[*part.material].rigid;
}

std::string Model::where(Place place) const {
  if (place.file.value >= files.size()) return "an unknown place";
  return fmt::format("line {} of {}", place.line, files[place.file.value]);
}

std::string Model::file(Place place) const {
  return place.file.value < files.size() ? files[place.file.value] : std::string();
}

}  // namespace gapcheck::model
