#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.hpp"
#include "report/export/exports.hpp"
#include "report/export/exports_groups.hpp"
#include "report/write/stream.hpp"

namespace gapcheck::report {
namespace {

/// Column widths of the two formats. In the long format every field has 20 columns.
struct Widths {
  int mesh_id, coordinate, field;
};
constexpr Widths standard{8, 16, 10}, long_format{20, 20, 20};
constexpr std::int64_t most_mesh_id = 99'999'999;

/// The number with as many digits as fit into `width` columns.
std::string fitted(double value, int width) {
  std::string text = fmt::format(FMT_COMPILE("{}"), value);
  for (int digits = 17; static_cast<int>(text.size()) > width && digits > 1; --digits)
    text = fmt::format(FMT_COMPILE("{:.{}g}"), value, digits);
  return text;
}

/// Leaves a blank before the number if that does not change it noticeably.
void append_coordinate(double value, int width, fmt::memory_buffer& out) {
  constexpr double noticeable = 1e-9;
  std::string text = fitted(value, width - 1);
  if (!(std::abs(parse_real(text).value_or(0) - value) < noticeable)) text = fitted(value, width);
  fmt::format_to(fmt::appender(out), FMT_COMPILE("{:>{}}"), text, width);
}

/// One beam of a group and the new ids that it takes.
struct Beam {
  std::int64_t id, part;
  const Penetration* record;
};

class BeamFile {
 public:
  BeamFile(const Report& report, const NodePosition& position, const Sink& sink)
      : report_(report), position_(position), groups_(export_groups(report)), stream_(sink), out_(stream_.buffer) {
    first_id_ = first_free_id(report);
    collect();
    const auto count = static_cast<std::int64_t>(std::max(2 * beams_.size(), groups_.size()));
    long_ = first_id_ + count > most_mesh_id;
    widths_ = long_ ? long_format : standard;
  }

  void write() {
    line(long_ ? "*KEYWORD LONG=Y" : "*KEYWORD");
    comment("Penetrations as beams: from each tracked node to the contact surface.");
    comment("The sets hold the tracked nodes themselves; these are defined in the model only.");
    comment(fmt::format("{} beams, {} records", beams_.size(), report_.penetrations.size()));
    write_nodes();
    write_beams();
    if (!beams_.empty()) write_properties();
    write_parts();
    write_sets();
    line("*END");
    stream_.flush();
  }

 private:
  void collect() {
    for (std::size_t g = 0; g < groups_.size(); ++g)
      for (const Penetration* record : groups_[g].penetrations) {
        if (penetration_line(report_, *record, position_))
          beams_.push_back({first_id_ + static_cast<std::int64_t>(beams_.size()), part_id(g), record});
        else
          not_drawn_.push_back({g, record});
      }
  }

  /// Also the id of the group's set.
  [[nodiscard]] std::int64_t part_id(std::size_t group) const { return first_id_ + static_cast<std::int64_t>(group); }
  [[nodiscard]] std::int64_t first_node(std::size_t beam) const {
    return first_id_ + 2 * static_cast<std::int64_t>(beam);
  }

  void line(std::string_view text) {
    out_.append(text);
    out_.push_back('\n');
  }
  void comment(std::string_view text) { fmt::format_to(fmt::appender(out_), "$ {}\n", text); }
  void field(std::int64_t value) { fmt::format_to(fmt::appender(out_), FMT_COMPILE("{:>{}}"), value, widths_.field); }
  void field(std::string_view value) {
    fmt::format_to(fmt::appender(out_), FMT_COMPILE("{:>{}}"), value, widths_.field);
  }
  void mesh_id(std::int64_t id, Buffer& out) const {
    fmt::format_to(fmt::appender(out), FMT_COMPILE("{:>{}}"), id, widths_.mesh_id);
  }

  void node(std::int64_t id, const Vector& x, Buffer& out) const {
    mesh_id(id, out);
    for (int k = 0; k < 3; ++k) append_coordinate(x[k], widths_.coordinate, out);
    out.push_back('\n');
  }

  void write_nodes() {
    if (beams_.empty()) return;
    line("*NODE");
    stream_.entries(beams_.size(), [this](std::size_t i, Buffer& out) {
      const auto drawn = penetration_line(report_, *beams_[i].record, position_);
      node(first_node(i), drawn->node, out);
      node(first_node(i) + 1, drawn->surface, out);
    });
  }

  void write_beams() {
    if (beams_.empty()) return;
    line("*ELEMENT_BEAM");
    stream_.entries(beams_.size(), [this](std::size_t i, Buffer& out) {
      for (const std::int64_t id : {beams_[i].id, beams_[i].part, first_node(i), first_node(i) + 1}) mesh_id(id, out);
      out.push_back('\n');
    });
  }

  /// Trusses, since they need no third node; one section and one material for all.
  void write_properties() {
    line("*SECTION_BEAM");
    field(first_id_);
    field(3);
    line("");
    field("1.0");
    line("");
    line("*MAT_ELASTIC");
    field(first_id_);
    for (const std::string_view value : {"1.0E-9", "1.0", "0.3"}) field(value);
    line("");
  }

  void write_parts() {
    std::int64_t last = 0;
    for (const Beam& beam : beams_) {  // groups are consecutive
      if (beam.part == last) continue;
      last = beam.part;
      line("*PART");
      line(groups_[static_cast<std::size_t>(beam.part - first_id_)].title);
      for (const std::int64_t id : {beam.part, first_id_, first_id_}) field(id);
      line("");
    }
  }

  void write_sets() {
    std::size_t next = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      line("*SET_NODE_LIST_TITLE");
      line(groups_[g].title);
      for (; next < not_drawn_.size() && not_drawn_[next].group == g; ++next)
        comment(fmt::format("node {}: penetration {}, position or direction not known: no beam",
                            not_drawn_[next].record->node, not_drawn_[next].record->depth));
      field(part_id(g));
      const std::vector<std::int64_t>& nodes = groups_[g].nodes;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (i % ids_per_card == 0) {
          line("");
          stream_.pause();
        }
        field(nodes[i]);
      }
      line("");
    }
  }

  struct NotDrawn {
    std::size_t group;
    const Penetration* record;
  };
  const Report& report_;
  const NodePosition& position_;
  std::vector<ExportGroup> groups_;
  std::vector<Beam> beams_;
  std::vector<NotDrawn> not_drawn_;
  std::int64_t first_id_ = 1;
  bool long_ = false;
  Widths widths_ = standard;
  Stream stream_;
  Buffer& out_;
};

}  // namespace

void keyword_beams(const Report& report, const NodePosition& position, const Sink& sink) {
  BeamFile(report, position, sink).write();
}

std::string keyword_beams(const Report& report, const NodePosition& position) {
  std::string text;
  keyword_beams(report, position, [&text](std::string_view piece) {
    text += piece;
    return true;
  });
  return text;
}

}  // namespace gapcheck::report
