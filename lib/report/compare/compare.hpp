#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "records/report.hpp"
#include "report/compare/compare_curves.hpp"
#include "report/compare/compare_motion.hpp"

namespace gapcheck::report {

/// How the records of one contact agree between two sources.
struct ContactComparison {
  std::int64_t id = 0;
  std::string title, type;
  std::uint64_t agree = 0, depth_differs = 0, only_first = 0, only_second = 0;
  std::uint64_t by_number = 0;    ///< of `agree`: one source lists them, the other only counts more nodes than it lists
  double largest_difference = 0;  ///< of depth
  bool missing_in_first = false, missing_in_second = false;  ///< the whole contact
  bool not_checked = false;    ///< one source did not decide it: its records are not compared
  bool tied = false;           ///< a deck's tied contact: its ties are compared instead of penetrations
  bool counts_only = false;    ///< one source gives the number of nodes and lists none: numbers are compared
  bool ties_compared = false;  ///< both sources say which nodes stay untied, and there are ties or such nodes
  std::uint64_t ties_agree = 0, ties_other_reason = 0, ties_only_first = 0, ties_only_second = 0;  ///< untied nodes
  std::uint64_t ties_out_of_reach = 0;  ///< untied nodes that one source lists and the other only counts
  [[nodiscard]] bool ties_equal() const { return ties_other_reason + ties_only_first + ties_only_second == 0; }
};

struct Difference {
  std::int64_t contact = 0, node = 0;
  double first = -1, second = -1;  ///< depth; negative: not in that source
};

/// A node that is untied in one source only, or for another reason.
struct TieDifference {
  std::int64_t contact = 0, node = 0;
  std::optional<TieReason> first, second;  ///< nothing: not untied in that source
};

/// A side of a contact with other time steps, or with the same one but another controlling node.
struct TimestepDifference {
  std::int64_t contact = 0;
  char side = 'A';
  double first = 0, second = 0;                  ///< surface time steps
  std::int64_t node_first = 0, node_second = 0;  ///< controlling; 0: none known
};

/// How the surface time steps agree that both sources have, printed or predicted.
struct TimestepComparison {
  std::uint64_t agree = 0, other_node = 0, differ = 0, only_first = 0, only_second = 0;  ///< sides of contacts
  std::vector<TimestepDifference> differences;                                           ///< by contact, then side
};

struct Comparison {
  std::vector<ContactComparison> contacts;     ///< as in the first report, then what only the second has
  std::vector<Difference> differences;         ///< by contact, then largest first
  std::vector<TieDifference> tie_differences;  ///< by contact, then node
  TimestepComparison timesteps;
  [[nodiscard]] bool equal() const;
};

/// Compares the initial-penetration records of two reports, contact by contact (by id), node by node; depths agree
/// within `tolerance` (absolute; plus half a unit in the fifth digit, which is what messag prints). A node that one
/// source calls released agrees with a record of the other; without one it is a difference only if the other source
/// lists released nodes of this contact at all, for it is not known whether the solver does. Nodes of the edge zone are
/// left out: the solver never lists them. A contact that only one source has is a difference only if it has records.
/// Untied nodes are compared as compare_ties() does.
[[nodiscard]] Comparison compare(const Report& first, const Report& second, double tolerance);

/// Compares the untied nodes of one contact, by node and reason; positions in Report::contacts, nothing: the report has
/// no such contact. Of several records of a node the first counts. A deck whose contact was not judged is not compared.
/// Nodes that are too far or on no segment are not a difference if the other side counts nodes out of reach without
/// listing them.
void compare_ties(const Report& first, std::optional<std::uint32_t> in_first, const Report& second,
                  std::optional<std::uint32_t> in_second, ContactComparison& sum,
                  std::vector<TieDifference>& differences);

/// Compares the surface time steps of two reports, by contact id and side; nothing if one has none. Steps agree within
/// half a unit in the fourth digit, which is what the solver prints. Of nodes that are equal to that precision the
/// solver names any, so another node is told apart but is not a difference.
[[nodiscard]] TimestepComparison compare_timesteps(const Report& first, const Report& second);

/// Two depths are the same: `tolerance` apart, plus half a unit in the fifth digit of the larger one.
[[nodiscard]] bool same_depth(double first, double second, double tolerance);

/// What two runs have besides records; nullptr: not compared.
struct RunComparison {
  const CurveComparison* curves = nullptr;
  const MotionComparison* motion = nullptr;
  [[nodiscard]] bool equal() const {
    return (curves == nullptr || curves->differ == 0) && (motion == nullptr || motion->differ == 0);
  }
};

/// `top`: largest differences to show, per contact, of the curves and of the parts' motion.
[[nodiscard]] std::string comparison_text(const Comparison& comparison, const Report& first, const Report& second,
                                          std::size_t top, const RunComparison& runs = {});
[[nodiscard]] std::string comparison_json(const Comparison& comparison, const Report& first, const Report& second,
                                          const RunComparison& runs = {});

}  // namespace gapcheck::report
