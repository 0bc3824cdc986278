#include "results/curves/run_results.hpp"

#include <filesystem>

#include "base/file_bytes.hpp"
#include "results/curves/binout.hpp"
#include "results/curves/intfor_history.hpp"

namespace gapcheck::results {

std::string RunResults::path(std::string_view name) const { return (std::filesystem::path(directory) / name).string(); }

RunResults read_run_results(const std::string& directory, bool nodes, Diagnostics& diagnostics) {
  RunResults run;
  run.directory = directory;
  const auto read = [&](const char* name, const auto& take) {
    const std::string path = run.path(name);
    std::error_code failed;
    if (!std::filesystem::exists(path, failed)) {
      run.missing.emplace_back(name);
      return;
    }
    const auto file = FileBytes::open(path);
    if (file)
      take(file.value().bytes(), path);
    else
      diagnostics.add(file.error());
  };
  const auto into = [&](auto& target, auto reader) {
    return [&target, reader, &diagnostics](std::string_view text, const std::string& path) {
      target = reader(text, path, diagnostics);
    };
  };
  using GlstatReader = std::vector<GlobalState> (*)(std::string_view, const std::string&, Diagnostics&);
  read("glstat", into(run.glstat, static_cast<GlstatReader>(read_glstat)));
  read("sleout", into(run.sleout, read_sleout));
  read("rcforc", into(run.rcforc, read_rcforc));
  read("matsum", into(run.matsum, read_matsum));
  if (nodes) read("nodout", into(run.nodout, read_nodout));
  const std::vector<std::string> with_binout = run.missing;
  if (nodes) {
    read("secforc", into(run.secforc, read_secforc));
    read("spcforc", into(run.spcforc, read_spcforc));
    read("bndout", into(run.bndout, read_bndout));
    read("rwforc", into(run.rwforc, read_rwforc));
    read("rbdout", into(run.rbdout, read_rbdout));
    read("swforc", into(run.swforc, read_swforc));
    read("elout", into(run.elout, read_elout));
    read("deforc", into(run.deforc, read_deforc));
    read("jntforc", into(run.jntforc, read_jntforc));
    read("abstat", into(run.abstat, read_abstat));
  }
  run.missing = with_binout;
  read_binout(run, nodes, diagnostics);
  if (nodes) run.intfor = read_intfor(run.path("intfor"), diagnostics);
  return run;
}

}  // namespace gapcheck::results
