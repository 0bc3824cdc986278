#include "audit/ids_in_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>

namespace gapcheck::audit {
namespace {

/// "node 1012 is 12 in mesh.k"; empty if it has the same id there.
std::string in_file(const keyword::Deck& deck, FileIndex file, keyword::IdKind kind, std::string_view what,
                    std::int64_t id) {
  const std::int64_t own = deck.id_in_file(file, kind, id);
  return own == 0 ? std::string() : fmt::format("{} {} is {} in {}", what, id, own, deck.file(file).path);
}

template <std::size_t N>
void add_file(const model::Elements<N>& elements, std::int64_t id, std::set<std::uint32_t>& files) {
  if (const auto found = elements.lookup.find(id)) files.insert(elements.origins.file(*found).value);
}

/// The file of an element; none if elements of several kinds have the id in different files.
std::optional<FileIndex> file_of_element(const model::Mesh& mesh, std::int64_t id) {
  std::set<std::uint32_t> files;
  add_file(mesh.shells, id, files);
  add_file(mesh.solids, id, files);
  add_file(mesh.thick_shells, id, files);
  add_file(mesh.beams, id, files);
  add_file(mesh.discrete, id, files);
  return files.size() == 1 ? std::optional(FileIndex(*files.begin())) : std::nullopt;
}

}  // namespace

void name_ids_in_files(const keyword::Deck& deck, const model::Model& model, std::vector<Finding>& findings) {
  const auto shifted = [&](const keyword::SourceFile& file) { return deck.transform(file.of_mesh).automatic; };
  if (std::none_of(deck.files().begin(), deck.files().end(), shifted)) return;
  const model::Nodes& nodes = model.mesh.nodes;
  for (Finding& finding : findings) {
    std::string text;
    if (const auto node = nodes.lookup.find(finding.node); finding.node != 0 && node)
      text = in_file(deck, nodes.origins.file(*node), keyword::IdKind::node, "node", finding.node);
    if (const auto file = finding.element == 0 ? std::nullopt : file_of_element(model.mesh, finding.element))
      if (const std::string element = in_file(deck, *file, keyword::IdKind::element, "element", finding.element);
          !element.empty())
        text += (text.empty() ? "" : ", ") + element;
    if (!text.empty()) finding.message += " (" + text + ")";
  }
}

}  // namespace gapcheck::audit
