#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::results {

/// All entities of one kind at one time.
struct EntityState {
  double time = 0;
  std::vector<std::int64_t> ids;  ///< 0: the kind has only one
  std::vector<double> values;     ///< one after the other for each entity: those of all columns
};

/// What a result file says about sections, walls, nodes, parts, welds, elements … over the whole run.
struct EntityHistory {
  struct Column {
    std::string quantity;  ///< "force"; columns of one quantity are comparable in size
    std::string name;      ///< "x-force"
  };
  std::string file;  ///< "secforc"
  std::string kind;  ///< "section"
  int digits = 6;    ///< that the text file prints of a number
  std::vector<Column> columns;
  std::vector<EntityState> states;  ///< in order of the file
};

}  // namespace gapcheck::results
