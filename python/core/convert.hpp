#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// Converts between Python's types and those of the C++ interface.
namespace gapcheck::python {

namespace py = pybind11;

/// Words of decks and messages, in which bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] py::str text(std::string_view bytes);

/// A path as os.fsdecode() gives it, so that any path can be given back.
[[nodiscard]] py::str path_text(std::string_view bytes);
[[nodiscard]] py::list path_texts(const std::vector<std::string>& paths);

/// The bytes of a str, bytes or os.PathLike. Raises TypeError for anything else, ValueError for a null byte inside.
[[nodiscard]] std::string path_of(py::handle given);

/// A read-only array over numbers that `owner` holds, without a copy; the array keeps `owner` alive. Enumerations are
/// their codes. `columns`: 0 for a list of numbers, else the length of a row.
template <class T>
[[nodiscard]] py::array view(std::span<const T> numbers, py::handle owner, std::size_t columns = 0) {
  using Number = typename std::conditional_t<std::is_enum_v<T>, std::underlying_type<T>, std::type_identity<T>>::type;
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(numbers.size() / (columns == 0 ? 1 : columns))};
  if (columns > 0) shape.push_back(static_cast<py::ssize_t>(columns));
  // An empty span may point nowhere, which would be a request for new memory.
  static const Number nothing{};
  const Number* first = numbers.empty() ? &nothing : reinterpret_cast<const Number*>(numbers.data());
  py::array_t<Number> array(shape, first, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

}  // namespace gapcheck::python
