#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/lsda_write.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"
#include "results/text/file_header.hpp"

namespace gapcheck::results {

/// Writes a binout: a directory for each branch ("/glstat"), in it "metadata" and a directory for each state, d000001,
/// …. A branch is a function that adds a state, see below; the next one needs no more than another such function.
class BinoutWriter {
 public:
  static Result<BinoutWriter> create(const std::string& path, const FileHeader& header,
                                     const LsdaWriteSettings& settings = {});

  /// Goes to the metadata of a branch and writes what all branches have; false if that was done before.
  bool begin_metadata(std::string_view branch);
  /// Goes to the next state of a branch and writes its time.
  void begin_state(std::string_view branch, double time);
  /// Metadata or states of the branch are written.
  [[nodiscard]] bool has(std::string_view branch) const { return states_.find(branch) != states_.end(); }
  /// The arrays legend and legend_ids: titles of 80 columns, ascending ids; none without entries.
  void legend(std::vector<LegendEntry> entries);
  /// The columns "x_force", "y_force", "z_force" for `word` "force"; with `prefix` "r" "rx_force", ….
  void vectors(std::string_view word, const std::vector<Vector>& values, std::string_view prefix = "");

  [[nodiscard]] LsdaWriter& file() { return file_; }
  [[nodiscard]] const LsdaWriter& file() const { return file_; }

 private:
  BinoutWriter(LsdaWriter file, const FileHeader& header) : file_(std::move(file)), header_(header) {}

  LsdaWriter file_;
  FileHeader header_;
  std::map<std::string, std::uint64_t, std::less<>> states_;  ///< by branch
};

// The branches, with the names that LS-DYNA gives their arrays; the first state is preceded by the metadata.

void add_glstat(BinoutWriter& binout, const GlobalState& state);
void add_matsum(BinoutWriter& binout, double time, const std::vector<LegendEntry>& titles,
                const std::vector<PartState>& parts);
void add_nodout(BinoutWriter& binout, const std::vector<LegendEntry>& titles, const NodeStates& state);
/// Two rows for each contact: side 0, side 1. Single surfaces have zeros, and 1 in the array "single".
void add_rcforc(BinoutWriter& binout, const std::vector<LegendEntry>& titles, const InterfaceStates& state);
/// Single surfaces have no row in the energies of side B.
void add_sleout(BinoutWriter& binout, const std::vector<LegendEntry>& titles, const InterfaceStates& state);

}  // namespace gapcheck::results
