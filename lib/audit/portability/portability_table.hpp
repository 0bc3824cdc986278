#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::audit {

/// One kind of contact that another program reads.
struct ReadKind {
  std::string_view name;                        ///< after `*CONTACT_`, without option words
  std::vector<std::string_view> fields;         ///< names as in the card layouts
  std::vector<std::string_view> other_meaning;  ///< those of them that mean something else there
  std::string_view source;
};

/// What another program reads of *CONTACT, by its documents.
struct OtherProgram {
  std::string_view name, source;
  std::vector<std::string_view> options;  ///< option words
  std::string_view option_source;
  std::vector<ReadKind> kinds;
  /// The row of a kind; nullptr: the program does not read it.
  [[nodiscard]] const ReadKind* find(std::string_view kind) const;
};

/// portability.txt.
struct PortabilityTable {
  std::vector<OtherProgram> programs;
  std::map<std::string_view, double> defaults;         ///< of fields whose default is not zero
  std::map<std::string_view, std::string_view> names;  ///< in messages
  std::vector<std::string_view> faults;                ///< lines that are not understood; a test keeps this empty
  /// The name of a field in messages.
  [[nodiscard]] std::string name_of(std::string_view field) const;
};

/// Views into the text, which must outlive the table.
[[nodiscard]] PortabilityTable read_portability_table(std::string_view text);

/// That of portability.txt; built on first use.
[[nodiscard]] const PortabilityTable& portability_table();

}  // namespace gapcheck::audit
