#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>
#include <string_view>

namespace taut::program {
namespace {

/// Text, built line by line.
class Table {
public:
  template <class... T>
  void line(fmt::format_string<T...> format, T&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<T>(values)...);
    text_ += '\n';
  }
  [[nodiscard]] std::string text() && { return std::move(text_); }

private:
  std::string text_;
};

std::string interval(double from, double to) {
  return std::isinf(to) ? fmt::format("above {:.3g}", from) : fmt::format("{:.3g} to {:.3g}", from, to);
}

void add_histogram(Table& table, std::string_view title, std::span<const double> bounds,
                   std::span<const std::size_t> counts) {
  constexpr double widest = 40;  // characters of the longest bar
  const auto all = static_cast<double>(std::max<std::size_t>(1, std::accumulate(counts.begin(), counts.end(), 0UL)));
  const auto most = static_cast<double>(std::max<std::size_t>(1, *std::ranges::max_element(counts)));
  table.line("\n{}", title);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto count = static_cast<double>(counts[i]);
    const auto length = static_cast<std::size_t>(std::lround(widest * count / most));
    const std::string bar = length == 0 ? "" : "  " + std::string(length, '#');
    table.line("  {:<14}{:>10}{:>8.2f} %{}", interval(bounds[i], bounds[i + 1]), counts[i], 100 * count / all, bar);
  }
}

void add_counts(Table& table, const Quality& q) {
  table.line("vertices      {}", q.vertices);
  table.line("edges         {}", q.edges);
  table.line("triangles     {}", q.triangles);
  table.line("tetrahedra    {}", q.tetrahedra);
  table.line("volume        {:.9g}", q.volume);
}

void add_lengths(Table& table, const Quality& q) {
  table.line("complexity    {:.6g} (integral of sqrt(det M))", q.complexity);
  table.line("tau           {:.4f} (efficiency index: 1 is perfect, about 0.944 is reachable)", q.tau);
  table.line("unit edges    {:.2f} % (length between 1/sqrt 2 and sqrt 2 in the metric)", 100 * q.unit_edges);
  table.line("edge lengths  {:.4g} to {:.4g} in the metric", q.length_min, q.length_max);
}

void add_shapes(Table& table, const Quality& q) {
  table.line(
      "Q             mean {:.3f}, worst {:.4g}, up to 2: {:.2f} %, up to 3: {:.2f} % (1 is best, larger is worse)",
      q.Q_mean, q.Q_max, 100 * q.Q_up_to_2, 100 * q.Q_up_to_3);
  table.line("mean ratio    mean {:.3f}, worst {:.4g} (1 is best, smaller is worse)", q.mean_ratio_mean,
             q.mean_ratio_min);
}

void add_components(Table& table, const TransferReport& report) {
  table.line("{:<16}{:>16}{:>16}{:>13}{:>15}{:>15}{:>17}{:>15}", "field component", "mass before", "after", "change",
             "least before", "after", "greatest before", "after");
  for (std::size_t f = 0; f < report.fields.size(); ++f)
    for (std::size_t c = 0; c < report.fields[f].size(); ++c) {
      const ComponentReport& r = report.fields[f][c];
      table.line("{:<16}{:>16.9g}{:>16.9g}{:>13.2e}{:>15.7g}{:>15.7g}{:>17.7g}{:>15.7g}",
                 fmt::format("{} {}", f + 1, c + 1), r.mass_before, r.mass_after, r.mass_after - r.mass_before,
                 r.least_before, r.least_after, r.greatest_before, r.greatest_after);
    }
  table.line("\nvolume          {:.9g} before, {:.9g} after", report.volume_before, report.volume_after);
  if (report.covered_volume)
    table.line("intersection    {:.9g}, {} pairs of tetrahedra", *report.covered_volume, report.overlaps);
  table.line("outside         {} points, at most {:.3g} from the old mesh", report.outside, report.distance_max);
}

std::string refusals(const PassReport& pass) {
  std::string text;
  for (const auto& [reason, count] : pass.refused) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", reason, count);
  }
  return text;
}

}  // namespace

std::string quality_table(const Quality& quality, bool in_metric) {
  Table table;
  add_counts(table, quality);
  if (in_metric) {
    add_lengths(table, quality);
  } else {
    table.line("edge lengths  {:.4g} to {:.4g}", quality.length_min, quality.length_max);
  }
  add_shapes(table, quality);
  if (in_metric)
    add_histogram(table, "edges by length in the metric", Quality::length_bounds, quality.length_histogram);
  add_histogram(table, "tetrahedra by Q (1 is best, larger is worse)", Quality::Q_bounds, quality.Q_histogram);
  return std::move(table).text();
}

std::string work_table(const Report& report) {
  Table table;
  table.line("{:<14}{:>10}{:>10}{:>10}{:>10}{:>9}  {}", "pass", "scanned", "tried", "accepted", "put off", "seconds",
             "refused");
  for (const PassReport& pass : report.passes) {
    table.line("{:<14}{:>10}{:>10}{:>10}{:>10}{:>9.3f}  {}", pass.name, pass.scanned, pass.tried, pass.accepted,
               pass.put_off, pass.seconds, refusals(pass));
  }
  table.line("\n{:<14}{:>9}", "phase", "seconds");
  for (const auto& [phase, seconds] : report.seconds) table.line("{:<14}{:>9.3f}", phase, seconds);
  return std::move(table).text();
}

std::string solution_table(const SolutionResult& result) {
  Table table;
  const double c = result.complexity;
  table.line("complexity    {:.6g} of the metric on the old mesh, about {:.3g} tetrahedra in a unit mesh\n", c,
             tetrahedra_per_complexity * c);
  if (!result.transferred.fields.empty()) add_components(table, result.transferred);
  return std::move(table).text();
}

std::string transfer_table(const TransferReport& report) {
  Table table;
  add_components(table, report);
  table.line("\n{:<14}{:>9}", "phase", "seconds");
  for (const auto& [phase, seconds] : report.seconds) table.line("{:<14}{:>9.3f}", phase, seconds);
  return std::move(table).text();
}

}  // namespace taut::program
