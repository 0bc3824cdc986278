#include "report/write/normal_path.hpp"

#include <filesystem>

namespace gapcheck::report {

std::string normal_path(std::string_view path) { return std::filesystem::path(path).lexically_normal().string(); }

}  // namespace gapcheck::report
