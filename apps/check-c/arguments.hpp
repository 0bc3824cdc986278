#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "report/text/check_c_view.hpp"

namespace gapcheck::check_c {

/// What the command line asks for.
struct Arguments {
  report::CheckCOptions view;
  bool top_given = false;  ///< exports are cut at -top only if it is given
  bool typ_given = false;  ///< once or more
  std::vector<std::string> files, message_files;
  std::string hsp, d3plot, deck;
  bool ani = false, a4sel = false, key = false, medina = false;
  std::int64_t medina_node = 9999999;
  bool help = false, version = false, quiet = false, stats = false;
  std::size_t jobs = 0;
};

/// Reads the arguments after the program's name.
[[nodiscard]] Result<Arguments> parse(const std::vector<std::string>& words);

/// The usage text, made from the table of options that `parse` uses.
[[nodiscard]] std::string usage();

/// An option as the usage shows it.
struct OptionText {
  std::string_view name, value, help;  ///< value empty: takes none; help: lines
};
[[nodiscard]] std::vector<OptionText> option_texts();

}  // namespace gapcheck::check_c
