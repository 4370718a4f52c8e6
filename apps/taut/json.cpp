#include "json.hpp"

#include <fmt/format.h>

#include <span>

#include "options.hpp"

namespace taut::program {
namespace {

Json histogram(std::span<const double> bounds, std::span<const std::size_t> counts) {
  Json bins = Json::array();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    bins.push_back({{"from", bounds[i]}, {"to", bounds[i + 1]}, {"count", counts[i]}});
  }
  return bins;
}

Json json_of(const PassReport& pass) {
  Json refused = Json::object();
  for (const auto& [reason, count] : pass.refused) refused[reason] = count;
  return {
      {"name", pass.name},  {"scanned", pass.scanned}, {"tried", pass.tried},     {"accepted", pass.accepted},
      {"refused", refused}, {"put_off", pass.put_off}, {"seconds", pass.seconds}, {"busy_seconds", pass.busy_seconds}};
}

Json json_of(const ComponentReport& component) {
  return {{"mass_before", component.mass_before},         {"mass_after", component.mass_after},
          {"least_before", component.least_before},       {"least_after", component.least_after},
          {"greatest_before", component.greatest_before}, {"greatest_after", component.greatest_after}};
}

void add_lengths(Json& json, const Quality& q) {
  json.update({{"complexity", q.complexity}, {"tau", q.tau}, {"unit_edges", q.unit_edges}});
  json["length_histogram"] = histogram(Quality::length_bounds, q.length_histogram);
}

}  // namespace

Json null_if_none(const std::optional<double>& number) {
  return number ? Json(*number) : Json();
}

Json null_if_empty(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json json_of_phases(const Phases& phases) {
  Json json = Json::object();
  for (const auto& [phase, seconds] : phases) json[phase] = seconds;
  return json;
}

Json json_of(const Quality& q, bool in_metric) {
  Json json = {{"vertices", q.vertices},
               {"edges", q.edges},
               {"triangles", q.triangles},
               {"tetrahedra", q.tetrahedra},
               {"volume", q.volume},
               {"length_min", q.length_min},
               {"length_max", q.length_max},
               {"Q_max", q.Q_max},
               {"Q_mean", q.Q_mean},
               {"Q_up_to_2", q.Q_up_to_2},
               {"Q_up_to_3", q.Q_up_to_3},
               {"mean_ratio_min", q.mean_ratio_min},
               {"mean_ratio_mean", q.mean_ratio_mean}};
  if (in_metric) add_lengths(json, q);
  json["Q_histogram"] = histogram(Quality::Q_bounds, q.Q_histogram);
  return json;
}

Json json_of(const Report& report) {
  Json passes = Json::array();
  for (const PassReport& pass : report.passes) passes.push_back(json_of(pass));
  return {{"expected_tetrahedra", report.expected_tetrahedra},
          {"rounds", report.rounds},
          {"threads", report.threads},
          {"blocks", report.blocks},
          {"cancelled", report.cancelled},
          {"passes", passes},
          {"seconds", json_of_phases(report.seconds)},
          {"reoriented", report.reoriented},
          {"triangles_built", report.triangles_built},
          {"edges_dropped", report.edges_dropped},
          {"triangles_frozen", report.triangles_frozen},
          {"off_surface", report.off_surface},
          {"hash", fmt::format("{:016x}", report.hash)}};
}

Json json_of(const AdaptJob& job) {
  const AdaptOptions& o = job.options;
  return {{"input", job.input},
          {"metric", null_if_empty(job.metric)},
          {"fields", job.field.files},
          {"output", job.output},
          {"metric_out", null_if_empty(job.metric_out)},
          {"field_out", null_if_empty(job.field.output)},
          {"options",
           {{"size", null_if_none(job.size)},
            {"optimise", job.optimise},
            {"local", null_if_empty(job.local)},
            {"surface", word_of(o.surface)},
            {"geometry", null_if_empty(job.geometry)},
            {"ridges", null_if_empty(job.ridges)},
            {"hmin", job.limits.bounds.hmin},
            {"hmax", job.limits.bounds.hmax},
            {"anisotropy", job.limits.bounds.anisotropy},
            {"gradation", null_if_none(job.limits.beta)},
            {"gradation_mix", job.limits.mix},
            {"angle", null_if_none(o.ridge_angle)},
            {"deviation", o.deviation > 0 ? Json(o.deviation) : Json()},
            {"rounds", o.max_rounds},
            {"threads", job.threads},
            {"block_size", o.block_size}}}};
}

Json json_of(const TransferReport& report) {
  Json fields = Json::array();
  for (const auto& components : report.fields) {
    Json& field = fields.emplace_back(Json::array());
    for (const ComponentReport& component : components) field.push_back(json_of(component));
  }
  return {{"outside", report.outside},
          {"distance_max", report.distance_max},
          {"volume_before", report.volume_before},
          {"volume_after", report.volume_after},
          {"covered_volume", null_if_none(report.covered_volume)},
          {"overlaps", report.overlaps},
          {"fields", fields},
          {"seconds", json_of_phases(report.seconds)}};
}

Json json_of(const FieldJob& job, const SolutionResult& result) {
  Json transfer = {{"method", word_of(job.transfer)}};
  if (job.transfer == Transfer::conservative) transfer.update(json_of(result.transferred));
  return {{"sizing",
           {{"asked_complexity", job.complexity},
            {"complexity", result.complexity},
            {"stopped_by", null_if_empty(result.stopped_by)},
            {"norm", job.norm},
            {"recovery", word_of(job.recovery)}}},
          {"transfer", transfer}};
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace taut::program
