#include "results/log/log_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/number.hpp"
#include "results/log/contact_echo.hpp"
#include "results/log/message_block.hpp"
#include "results/log/message_records.hpp"
#include "results/log/node_lines.hpp"
#include "results/log/run_facts.hpp"
#include "results/text/lines.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

constexpr std::size_t release_step = std::size_t{4} << 20, head_size = std::size_t{1} << 16;

/// A d3plot, an archive, UTF-16: many bytes that do not occur in text.
bool is_binary(std::string_view text) {
  const std::string_view head = text.substr(0, head_size);
  const auto controls = std::count_if(head.begin(), head.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
  });
  return static_cast<std::size_t>(controls) * 10 > head.size();
}

class FileReader {
 public:
  /// `bytes`: of a file on disk, otherwise null.
  FileReader(Lines lines, std::size_t size, FileBytes* bytes, const MessageKinds& kinds, LogCollector& collector)
      : lines_(std::move(lines)),
        size_(size),
        bytes_(bytes),
        kinds_(kinds),
        collector_(collector),
        echo_(collector),
        facts_(collector),
        nodes_(collector) {}

  bool read() {
    std::string_view before;
    while (!lines_.done()) {
      const std::string_view line = lines_.line();
      release_before(before.empty() ? line : before);
      if (dispatch(line, before)) {
        recognised_ = true;
        before = line;
        continue;
      }
      before = line;
      last_open_ = lines_.open();
      lines_.advance();
    }
    note_end();
    return recognised_;
  }

 private:
  /// Line numbers are kept, text already read is not: memory grows only with what is found. `view`: the first text
  /// that is still used.
  void release_before(std::string_view view) {
    if (bytes_ == nullptr || lines_.offset() < released_ + 2 * release_step || view.empty()) return;
    const auto end = static_cast<std::size_t>(view.data() - bytes_->bytes().data()) / release_step * release_step;
    if (end > released_) bytes_->release(released_, end);
    released_ = end;
  }

  void note_end() {
    const auto last = lines_.number();
    if (const auto count = lines_.cut_lines(); count > 0)
      collector_.error(lines_.first_cut(), fmt::format("is longer than {} bytes and was cut ({} such line{}); the file "
                                                       "may be damaged, look at this line",
                                                       Lines::longest, count, count == 1 ? "" : "s"));
    if (lines_.first_nul() > 0)
      collector_.error(lines_.first_nul(), "holds NUL bytes: the file is damaged; what could be read was read");
    if (last_open_ && recognised_)
      collector_.warning(last, "the last line has no end: the file may have been cut, or is still written");
    if (!lines_.status().ok()) collector_.error(last, lines_.status().error().message);
    collector_.count_bytes(size_, last);
  }

  /// Consumes the line and those that belong to it; false: it has no meaning, and is still the current one.
  bool dispatch(std::string_view line, std::string_view before) {
    const std::string_view text = trimmed(line);
    if (text.empty()) return false;
    if (text.starts_with("*** ") && is_message_header(line)) return read_block();
    return take_block_of_lines(text) || (take_line(text, before) && one_line());
  }

  bool one_line() {
    lines_.advance();
    return true;
  }

  bool take_block_of_lines(std::string_view text) {
    switch (text.front()) {
      case 's':
      case 'm':
      case 't':
      case 'r':
        return echo_.surface_timestep(lines_, text) || nodes_.initial_summary(lines_, text);
      case 'C':
        return echo_.interface_heading(lines_, text) || echo_.summary(lines_, text) || nodes_.mortar(lines_, text);
      case '1':
        return facts_.smallest_timesteps(lines_, text);
      case 'S':
        return nodes_.warning_summary(lines_, text);
      default:
        return false;
    }
  }

  bool take_line(std::string_view text, std::string_view before) {
    switch (text.front()) {
      case '|':
        return facts_.banner_line(text);
      case 'g':
      case 'l':
        if (facts_.version_stamp(text, before)) return true;
        break;
      case 'N':
      case 'E':
        if (facts_.termination(text)) return true;
        break;
      case 'P':
        if (facts_.problem_line(text) || facts_.ranks(text)) return true;
        break;
      case 'I':
        if (echo_.timing_row(text)) return true;
        break;
      case 't':
        if (facts_.end_time(text)) return true;
        break;
      case 'T':
        if (facts_.contact_limit(text, lines_.number())) return true;
        break;
      case 'M':
        if (facts_.ranks(text) || message_limit(text)) return true;
        break;
      case 'c':
      case 'n':
        if (echo_.echo_line(text)) return true;
        break;
      case 'i':
        if (text.starts_with("input of data is completed") || text.starts_with("initialization completed")) {
          collector_.mark_stdout();
          return true;
        }
        break;
      default:
        if (text.front() >= '0' && text.front() <= '9' && (facts_.cycle_line(text) || nodes_.count_line(text)))
          return true;
    }
    if (is_solver_line(text)) return true;
    return nodes_.node_line(lines_, text);
  }

  /// Lines that only the solver prints, but without a fact.
  bool is_solver_line(std::string_view text) {
    if (text.starts_with("total # of *") || text.starts_with("c o n t ")) {
      collector_.mark_d3hsp();
      return true;
    }
    return text.starts_with("expanding   memory") || text.starts_with("contracting memory") ||
           text.starts_with("cpu time per zone cycle") || text.starts_with("gapcheck: ");
  }

  /// "Maximum number of messages.....................       0" of the d3hsp.
  bool message_limit(std::string_view text) {
    constexpr std::string_view words = "Maximum number of messages";
    if (!text.starts_with(words)) return false;
    std::string_view rest = text.substr(std::min(text.find_first_not_of('.', words.size()), text.size()));
    if (const auto limit = take_integer(rest); limit && *limit > -1'000'000'000) collector_.set_message_limit(*limit);
    return true;
  }

  bool read_block() {
    read_message_block(lines_, block_);
    if (collector_.companion()) return true;
    collector_.messages().count_block(block_.code);
    const MessageKind* kind = kinds_.find(block_);
    bool recorded = false, awaits_more = false;
    if (kind != nullptr && kind->record != BlockRecord::none) recorded = record(*kind, awaits_more);
    if (!recorded) list_block(kind);
    if (block_.open || (block_.ends_file && awaits_more))
      collector_.error(block_.line, fmt::format("the file ends inside a message block ({} {}, line {})",
                                                block_.severity == Severity::error ? "Error" : "Warning", block_.code,
                                                lines_.number()));
    return true;
  }

  /// True if the block became a record.
  bool record(const MessageKind& kind, bool& awaits_more) {
    switch (kind.record) {
      case BlockRecord::penetration:
      case BlockRecord::released: {
        auto found = penetration_of(block_, kind);
        awaits_more = found.awaits_more;
        return keep(kind, found);
      }
      case BlockRecord::tie: {
        auto found = tie_failure_of(block_, kind);
        awaits_more = !found.complete;
        return keep(kind, found);
      }
      case BlockRecord::rigidwall: {
        auto found = rigidwall_of(block_);
        awaits_more = !found.complete;
        return keep(kind, found);
      }
      case BlockRecord::cut:
        collector_.run().counts_may_be_cut = true;
        return false;
      case BlockRecord::none:
        return false;
    }
    return false;
  }

  template <class Found>
  bool keep(const MessageKind& kind, Found& found) {
    // A kind recognised only by its words may be just a remark; one recognised by its number has all of its fields.
    if (!found.fault.what.empty() && (found.complete || !kind.codes.empty()))
      collector_.error(found.fault.line, found.fault.what);
    if (!found.complete) return false;
    if constexpr (requires { found.record.contact; }) found.record.contact = collector_.slot(found.contact);
    found.record.file = collector_.file();
    found.record.line = block_.line;
    collector_.add(found.record);
    return true;
  }

  void list_block(const MessageKind* kind) {
    static const std::string unknown;
    const std::string& name = kind == nullptr ? unknown : kind->name;
    MessageLog& log = collector_.messages();
    if (!log.count(block_.severity, block_.code, name, text_hash(block_), collector_.file())) return;
    log.keep({block_.severity, block_.code, std::string(block_.group), name,
              joined_text(block_, MessageLog::longest_text), 1, collector_.file(), block_.line});
  }

  Lines lines_;
  std::size_t size_;
  FileBytes* bytes_;
  const MessageKinds& kinds_;
  LogCollector& collector_;
  ContactEcho echo_;
  RunFacts facts_;
  NodeLines nodes_;
  MessageBlock block_;
  std::size_t released_ = 0;
  bool recognised_ = false, last_open_ = false;
};

/// `head`: the beginning, which says what it is. `read`: reads the whole and says whether it was a log.
template <class Read>
bool read_if_text(std::string_view head, const LogFile& file, LogCollector& collector, const Read& read) {
  collector.begin_file(file.name, file.companion);
  bool recognised = true;
  if (head.empty())
    collector.error(0, "is empty; give the messag, mesNNNN or d3hsp file of a run");
  else if (is_binary(head))
    collector.error(0, "is binary, no text; give the messag, mesNNNN or d3hsp file of a run");
  else
    recognised = read();
  collector.end_file();
  return recognised;
}

}  // namespace

bool read_log_file(std::string_view text, const LogFile& file, const MessageKinds& kinds, LogCollector& collector) {
  return read_if_text(text, file, collector,
                      [&] { return FileReader(Lines(text), text.size(), nullptr, kinds, collector).read(); });
}

bool read_log_file(FileBytes& bytes, const LogFile& file, const MessageKinds& kinds, LogCollector& collector) {
  if (const Status head = bytes.load(head_size); !head.ok()) {
    collector.begin_file(file.name, file.companion);
    collector.error(0, head.error().message);
    collector.end_file();
    return true;
  }
  return read_if_text(bytes.bytes(), file, collector,
                      [&] { return FileReader(Lines(bytes), bytes.size(), &bytes, kinds, collector).read(); });
}

}  // namespace gapcheck::results
