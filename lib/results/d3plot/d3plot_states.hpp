#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/file_bytes.hpp"
#include "base/result.hpp"
#include "results/d3plot/d3plot.hpp"
#include "results/d3plot/d3plot_state.hpp"

namespace gapcheck::results {

/// Where the values of a state lie, in words from its beginning; counts are those of the header, checked against the
/// geometry that was read.
struct D3plotStateLayout {
  std::uint64_t words = 0;  ///< of a whole state
  std::uint64_t globals = 0, parts = 0;
  std::uint64_t coordinates = 0, velocities = 0, solids = 0, beams = 0, shells = 0;  ///< 0: not there
  std::uint64_t deletion = 0;  ///< a word for each solid, thick shell, shell and beam, 0 if it is deleted; 0: absent
  std::uint64_t solid_words = 0, beam_words = 0, shell_words = 0;  ///< of one element
  std::uint64_t layers = 0, layer_words = 0;                       ///< of a shell
  bool layer_stress = false, layer_strain = false, shell_resultants = false, shell_thickness = false;
  std::vector<std::uint32_t> shells_with_values;  ///< positions; the others are rigid and have none
  unsigned dimensions = 3;
};

/// The states of a d3plot and its file family: located on opening, read one by one. States follow the geometry in its
/// own file or begin with the next one; each lies in one file. Limits: models with particles, fluids, airbags or road
/// surfaces are an error; values of thick shells, accelerations, temperatures, strains, history variables and layers
/// beyond the three surfaces are skipped.
class D3plotStates {
 public:
  static Result<D3plotStates> open(const std::string& path, DatabaseKind kind = DatabaseKind::plot);

  [[nodiscard]] const D3plot& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] std::size_t size() const { return times_.size(); }
  [[nodiscard]] const D3plotStateLayout& layout() const { return layout_; }
  /// State i < size().
  [[nodiscard]] D3plotState read(std::size_t i) const;
  /// All values of all shells of state i, as they are in the file: D3plotStateLayout::shell_words for each.
  [[nodiscard]] std::vector<double> shell_words(std::size_t i) const;

 private:
  struct Place {
    std::uint32_t file;
    std::uint64_t word;
  };
  D3plotStates() = default;
  void find_states(std::uint32_t file, std::uint64_t word);

  D3plot mesh_;
  D3plotStateLayout layout_;
  std::size_t word_bytes_ = 4;
  bool swapped_ = false;
  std::vector<FileBytes> files_;
  std::vector<Place> places_;
  std::vector<double> times_;
};

}  // namespace gapcheck::results
