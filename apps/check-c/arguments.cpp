#include "arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/number.hpp"

namespace gapcheck::check_c {
namespace {

using Value = std::string;

/// Takes an option's value. The error says what is wrong with it.
using Set = Status (*)(Arguments&, const Value&);

struct Option {
  std::string_view name;
  std::string_view value;  ///< as the usage shows it; empty: takes none
  std::string_view help;   ///< lines
  Set set;
};

Status set_amount(const Value& text, double& amount) {
  const std::optional<double> value = parse_real(text);
  if (!value || !(*value >= 0)) return plain_error("is not a number of 0 or more");
  amount = *value;
  return {};
}

template <class Integer>
Status set_count(const Value& text, std::int64_t least, std::int64_t most, Integer& count) {
  const std::optional<std::int64_t> value = parse_integer(text);
  if (!value || *value < least || *value > most)
    return plain_error(fmt::format("is not a whole number of {} to {}", least, most));
  count = static_cast<Integer>(*value);
  return {};
}

/// "1,2,3"; empty entries, as in "1,2,", are skipped.
Status set_ids(const Value& text, std::vector<std::int64_t>& ids) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view entry = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), entry.size() + 1));
    if (entry.empty()) continue;
    const std::optional<std::int64_t> id = parse_integer(entry);
    if (!id) return plain_error("is not a list of whole numbers");
    ids.push_back(*id);
  }
  if (ids.empty()) return plain_error("names no interface");
  return {};
}

Status set_selection(Arguments& arguments, const Value& text) {
  if (!report::known_selection(text)) return plain_error("is not a warning type; check-c -help lists them");
  arguments.view.sel = text;
  return {};
}

/// A flag of the view, of the arguments.
template <auto Member>
Status view_flag(Arguments& arguments, const Value&) {
  arguments.view.*Member = true;
  return {};
}
template <auto Member>
Status flag(Arguments& arguments, const Value&) {
  arguments.*Member = true;
  return {};
}
template <auto Member>
Status text(Arguments& arguments, const Value& value) {
  if (value.empty()) return plain_error("is empty");
  arguments.*Member = value;
  return {};
}

/// A second -typ asks for keywords instead of codes.
Status set_type(Arguments& arguments, const Value&) {
  const bool again = arguments.typ_given;
  arguments.typ_given = true;
  if (again) arguments.view.type_keyword = true;
  arguments.view.type_code = !again;
  return {};
}

constexpr std::int64_t most_nodes = 1'000'000'000'000;

constexpr std::string_view selections = R"(select one type of warning (default: all)
words for tied contacts:
  tied      every warning of a tied contact
  sep       separated nodes that are moved onto the segment
  offset    separated nodes that are not moved, and tied all the same:
            the offset stays
  far       nodes too far from the segment (untied)
  short     nodes whose tie would shorten a beam (untied)
  notfound  nodes that are on no segment (untied)
  rigslav   rigid tracked nodes (untied)
  rigmast   nodes on a segment with a rigid node (untied)
  conflict  nodes that something else constrains already (untied)
  untied    all types that leave nodes untied
words for standard contacts:
  typ13     every warning of a standard contact
  pen       penetrating nodes
  mid, del, below
            nodes too deep below the surface: contact lets go of them
words for contacts with SOFT=2:
  soft2     every warning of such a contact
  inter     intersections of elements
  war       every warning of such a contact
  first     the first of these warnings
  last      the last of these warnings)";

const std::array options{
    Option{"-list", "", "list every node, and the text of the solver's other messages",
           view_flag<&report::CheckCOptions::list>},
    Option{"-top", "##", "list and output the ## largest values (default: 5; files: all)",
           [](Arguments& a, const Value& v) {
             a.top_given = true;
             return set_count(v, 0, most_nodes, a.view.top);
           }},
    Option{"-ptol", "##", "list and output only penetrations and separations > ##",
           [](Arguments& a, const Value& v) { return set_amount(v, a.view.ptol); }},
    Option{"-sid", "#,#,#", "only interfaces #, #, #",
           [](Arguments& a, const Value& v) { return set_ids(v, a.view.sid); }},
    Option{"-bucket", "", "print how the penetrations of each interface are spread",
           view_flag<&report::CheckCOptions::bucket>},
    Option{"-pid", "", "print the part of each node (needs -g or --deck)", view_flag<&report::CheckCOptions::pid>},
    Option{"-psum", "", "print a summary by parts (needs -g or --deck)", view_flag<&report::CheckCOptions::psum>},
    Option{"-rsort", "", "sort by remaining distance (default: by penetration)",
           view_flag<&report::CheckCOptions::rsort>},
    Option{"-rtol", "##", "list and output only penetrations with a remaining distance < ##",
           [](Arguments& a, const Value& v) { return set_amount(v, a.view.rtol); }},
    Option{"-title", "", "print contact titles where there are any (from the d3hsp file)",
           view_flag<&report::CheckCOptions::title>},
    Option{"-hsp", "<file>", "d3hsp file (default: d3hsp beside the first messag-file)", text<&Arguments::hsp>},
    Option{"-typ", "", "print contact types as codes (a3, 13, a13); twice: as -type", set_type},
    Option{"-type", "", "print contact types as keywords (SINGLE_SURFACE); also -typkey",
           view_flag<&report::CheckCOptions::type_keyword>},
    Option{"-timestep", "", "print contact time steps where there are any",
           view_flag<&report::CheckCOptions::timestep>},
    Option{"-all", "", "list all contacts, also those without warnings\n(good with -timestep and -typ)",
           view_flag<&report::CheckCOptions::all>},
    Option{"-g", "<d3plot>",
           "d3plot file with the mesh (default: d3plot beside the first\nmessag-file, where parts or coordinates are "
           "needed)",
           text<&Arguments::d3plot>},
    Option{"-ani", "", "write check-c.ses: Animator session that shows the nodes\nwith \"ide nod xxx\"",
           flag<&Arguments::ani>},
    Option{"-a4sel", "",
           "write check-c.ses: Animator 4 session with \"sel nod xxx\" and\ngroups \"id<sid> <warn-type>\"",
           flag<&Arguments::a4sel>},
    Option{"-sel", "<typ>", selections, set_selection},
    Option{"-key", "", "write check-c.key: keyword file with one beam per penetration,\nas long as the penetration",
           flag<&Arguments::key>},
    Option{"-medina", "", "write check-c.prt: Medina protocol", flag<&Arguments::medina>},
    Option{"-mnode", "##", "first id of new nodes in the Medina protocol (default: 9999999)",
           [](Arguments& a, const Value& v) { return set_count(v, 1, most_nodes, a.medina_node); }},
    Option{"-version", "", "print the version", flag<&Arguments::version>},
    Option{"-help", "", "print this text; also -h", flag<&Arguments::help>},
    Option{"--deck", "<file>", "keyword deck with the mesh, instead of -g", text<&Arguments::deck>},
    Option{"--messages", "<file>", "additions to the table of known messages",
           [](Arguments& a, const Value& v) {
             a.message_files.push_back(v);
             return Status();
           }},
    Option{"--quiet", "", "no warnings about the input", flag<&Arguments::quiet>},
    Option{"--jobs", "##", "threads (default: as many as the machine has)",
           [](Arguments& a, const Value& v) { return set_count(v, 0, 4096, a.jobs); }},
    Option{"--stats", "", "print counters and times on standard error", flag<&Arguments::stats>},
};

/// Other spellings.
std::string_view canonical(std::string_view word) {
  if (word == "-typkey") return "-type";
  if (word == "-h" || word == "--help") return "-help";
  return word == "--version" ? "-version" : word;
}

const Option* find(std::string_view word) {
  const auto same = [name = canonical(word)](const Option& option) { return option.name == name; };
  const auto found = std::find_if(options.begin(), options.end(), same);
  return found == options.end() ? nullptr : &*found;
}

/// Columns of a text: every byte except UTF-8 continuation bytes counts as one.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// The help's lines, all starting in the same column.
void append_help(const Option& option, std::string& out) {
  constexpr std::size_t column = 20;
  std::string left = "  " + std::string(option.name);
  if (!option.value.empty()) left += ' ' + std::string(option.value);
  std::string_view rest = option.help;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    out += left;
    out.append(column - std::min(column - 1, width(left)), ' ');
    out += line;
    out += '\n';
    left.clear();
  }
}

}  // namespace

Result<Arguments> parse(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const Option* option = find(word);
    if (option == nullptr) {
      if (word.size() > 1 && word.front() == '-') return plain_error(fmt::format("unknown option '{}'", word));
      arguments.files.push_back(word);
      continue;
    }
    const bool takes_value = !option->value.empty();
    if (takes_value && (i + 1 == words.size() || find(words[i + 1]) != nullptr))
      return plain_error(fmt::format("{} needs a value: {}", word, option->value));
    const std::string& value = takes_value ? words[++i] : word;
    if (const Status status = option->set(arguments, value); !status.ok())
      return plain_error(fmt::format("{}: '{}' {}", word, value, status.error().message));
  }
  if (arguments.ani && arguments.a4sel) return plain_error("-ani and -a4sel write the same file: give one of them");
  if (arguments.files.empty() && !arguments.help && !arguments.version) return plain_error("no messag-file is given");
  return arguments;
}

std::string usage() {
  std::string out = "usage: check-c [options] messag-file[s]\noptions:\n";
  for (const Option& option : options) append_help(option, out);
  return out +
         "exit codes: 0 no warnings, 1 warnings, 2 bad arguments or input that cannot be read\n"
         "example: check-c -title -typ -pid -key messag\n";
}

std::vector<OptionText> option_texts() {
  std::vector<OptionText> texts;
  texts.reserve(std::size(options));
  for (const Option& option : options) texts.push_back({option.name, option.value, option.help});
  return texts;
}

}  // namespace gapcheck::check_c
