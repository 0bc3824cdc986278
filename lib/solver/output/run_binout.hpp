#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/entity/output.hpp"
#include "results/curves/binout_write.hpp"
#include "results/text/file_header.hpp"
#include "solver/output/text_files.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// True if the file is written as text: where its card says BINARY = 0, 1 or 3, and `all`ways with the option that asks
/// for a binout of everything.
[[nodiscard]] bool writes_text(const model::Output& output, std::string_view file, bool all);

/// Writes the binout of a run, binout0000: the files whose cards say BINARY = 2 or 3, or `all` of them.
class RunBinout : public Run::Observer {
 public:
  /// `output`: of the deck. Removes the binouts of earlier runs. Creates no file and returns nullptr if there is
  /// nothing to write.
  static SolverResult<std::unique_ptr<RunBinout>> create(const std::string& directory,
                                                         const results::FileHeader& header,
                                                         const std::vector<TextFile>& files,
                                                         const model::Output& output, bool all);
  ~RunBinout() override;

  [[nodiscard]] SolverStatus observe(const Run& run, std::optional<RunEnd> end) override;
  /// A failure if a file is no longer where it was written.
  [[nodiscard]] SolverStatus check_names() const;
  [[nodiscard]] static std::string name() { return "binout0000"; }

 private:
  struct Branch;
  explicit RunBinout(results::BinoutWriter binout);

  results::BinoutWriter binout_;
  std::vector<Branch> branches_;
};

}  // namespace gapcheck::solver
