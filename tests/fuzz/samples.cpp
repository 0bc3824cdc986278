#include "samples.hpp"

#include <string>

#include "audit/audit.hpp"
#include "fuzz.hpp"
#include "results/log/solver_log.hpp"
#include "results/log/write_messag.hpp"

namespace gapcheck::fuzz {

std::string_view sample_deck() {
  return "*KEYWORD\n*NODE\n1,0,0,0\n2,4,0,0\n3,4,4,0\n4,0,4,0\n5,1,1,.5\n6,3,1,.6\n7,3,3,.7\n8,1,3,8\n"
         "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,5,6,7,8\n*PART\na\n1,1,1\n*PART\nb\n2,1,1\n"
         "*SECTION_SHELL\n1,2\n1.,1.,1.,1.\n*MAT_ELASTIC\n1,7.8e-6,210.,.3\n"
         "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n1,first\n2,1,3,3\n\n\n"
         "*CONTACT_TIED_NODES_TO_SURFACE_ID\n2,second\n2,1,3,3\n\n\n*END\n";
}

const Report& sample_audit() {
  static const Report report = [] {
    Diagnostics diagnostics;
    auto audited = audit::audit_text(std::string(sample_deck()), "sample.k", {}, diagnostics);
    require(audited.ok() && !audited.value().penetrations.empty() && !audited.value().tie_failures.empty());
    return std::move(audited).value();
  }();
  return report;
}

const Report& sample_log() {
  static const Report report = [] {
    Diagnostics diagnostics;
    const std::string log = results::write_messag(sample_audit());
    Report read = results::read_solver_log_text(log, "messag", {}, diagnostics);
    require(!read.penetrations.empty());
    return read;
  }();
  return report;
}

}  // namespace gapcheck::fuzz
