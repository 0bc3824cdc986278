#pragma once
#include <memory>
#include <optional>
#include <string>

#include "contact/surface/contact_surfaces.hpp"
#include "results/d3plot/intfor_write.hpp"
#include "solver/output/interface_plot.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// Writes the interface force database of a run, intfor, for the contact sides that SAPR and SBPR name.
class RunIntfor : public Run::Observer {
 public:
  /// Removes the intfor of an earlier run. Without an interval or a segment it writes no file and returns nullptr.
  static SolverResult<std::unique_ptr<RunIntfor>> create(const Run& run, contact::SurfaceStore& surfaces,
                                                         const std::string& directory, double interval,
                                                         bool double_words);
  ~RunIntfor() override;

  /// The next observation writes a state.
  [[nodiscard]] bool due(double time) const;
  [[nodiscard]] SolverStatus observe(const Run& run, std::optional<RunEnd> end) override;
  /// A failure if a file is no longer where it was written.
  [[nodiscard]] SolverStatus check_names() const;
  [[nodiscard]] static std::string name() { return "intfor"; }

 private:
  struct Content;
  explicit RunIntfor(std::unique_ptr<Content> content);

  std::unique_ptr<Content> content_;
};

}  // namespace gapcheck::solver
