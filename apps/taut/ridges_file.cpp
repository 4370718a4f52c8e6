#include "ridges_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "files.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/ridges.hpp"

namespace taut::program {
namespace {

using Edge = std::array<Index, 2>;

bool is_mesh(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  return std::ranges::find(mesh_files, extension) != mesh_files.end();
}

/// For messages, on one line.
std::string shown(std::string text) {
  constexpr std::size_t longest = 40;
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

/// From 0. None if the word is no number, counted from 1.
std::optional<Index> index_in(const std::string& word) {
  Index number = 0;
  const char* end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc{} || last != end || number == 0) return std::nullopt;
  return number - 1;
}

/// The edge of a line; none if it holds nothing but a comment.
std::optional<Edge> edge_in(const std::string& line, const std::string& file, std::size_t number) {
  std::istringstream words(line.substr(0, line.find('#')));
  std::vector<std::optional<Index>> found;
  for (std::string word; words >> word;) found.push_back(index_in(word));
  if (found.empty()) return std::nullopt;
  if (found.size() != 2 || !found[0] || !found[1])
    throw InputError(fmt::format("{}: line {}: two vertex numbers expected, counted from 1, found \"{}\"", file, number,
                                 shown(line)));
  return Edge{*found[0], *found[1]};
}

std::vector<Edge> read_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(fmt::format("{}: cannot be read", file));
  std::vector<Edge> edges;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);)
    if (const auto edge = edge_in(line, file, ++number)) edges.push_back(*edge);
  if (edges.empty()) throw InputError(fmt::format("{}: no edges found", file));
  return edges;
}

}  // namespace

Mesh with_ridges_of(const std::string& file, Mesh mesh, const std::string& mesh_file) {
  const auto with = [&](const auto& ridges) {
    return with_files(mesh_file, {{"ridges: ", file}}, [&] { return with_ridges(std::move(mesh), ridges); });
  };
  return is_mesh(file) ? with(read_edges(file)) : with(read_text(file));
}

}  // namespace taut::program
