#include "move_report.hpp"

#include <algorithm>

#include "options.hpp"

namespace taut::program {
namespace {

Json json_of_obstacle(const Obstacle& obstacle) {
  return {{"reason", obstacle.reason == Obstacle::Reason::contact ? "contact" : "tangle"},
          {"place", obstacle.place},
          {"body", obstacle.body},
          {"other", obstacle.other},
          {"gap", obstacle.gap},
          {"size", obstacle.size}};
}

Json json_of_step(const MoveStep& step) {
  const Quality& q = step.quality;
  return {{"step", step.step},
          {"file", null_if_empty(step.file)},
          {"share", step.done.share},
          {"obstacle", step.done.obstacle ? json_of_obstacle(*step.done.obstacle) : Json()},
          {"parts", step.done.parts},
          {"off_surface", step.done.off_surface},
          {"iterations", step.done.iterations},
          {"vertices", q.vertices},
          {"tetrahedra", q.tetrahedra},
          {"tau", q.tau},
          {"Q_max", q.Q_max},
          {"Q_up_to_3", q.Q_up_to_3},
          {"unit_edges", q.unit_edges},
          {"seconds", json_of_phases(step.done.seconds)}};
}

Json totals_of(const MoveReport& report) {
  double worst = 0;
  int parts = 0, iterations = 0;
  Phases phases = {{"read", report.read}};
  for (const MoveStep& step : report.steps) {
    worst = std::max(worst, step.quality.Q_max);
    parts += step.done.parts;
    iterations += step.done.iterations;
    for (const auto& [phase, seconds] : step.done.seconds) add_phase(phases, phase, seconds);
  }
  phases.emplace_back("all", report.seconds);
  return {{"steps", report.steps.size() - 1},
          {"parts", parts},
          {"iterations", iterations},
          {"Q_max", worst},
          {"seconds", json_of_phases(phases)}};
}

Json options_of(const MoveJob& job) {
  const MotionOptions& o = job.options;
  const Limits& bounds = job.limits.bounds;
  return {{"size", job.size ? Json(*job.size) : Json()},
          {"steps", job.steps},
          {"every", job.every},
          {"mode", word_of(o.changes)},
          {"follow", word_of(o.following)},
          {"rounds", o.rounds},
          {"stiffening", o.stiffening},
          {"shell", o.shell},
          {"metric_follows", o.metric_follows ? Json(*o.metric_follows) : Json()},
          {"transfer", word_of(o.transfer)},
          {"surface", word_of(o.adaptation.surface)},
          {"geometry", null_if_empty(job.geometry)},
          {"hmin", bounds.hmin},
          {"hmax", bounds.hmax},
          {"anisotropy", bounds.anisotropy},
          {"gradation", null_if_none(job.limits.beta)},
          {"gradation_mix", job.limits.mix},
          {"angle", null_if_none(o.adaptation.ridge_angle)},
          {"threads", job.threads}};
}

}  // namespace

void add_phase(Phases& phases, const std::string& phase, double seconds) {
  const auto known = std::ranges::find(phases, phase, &Phases::value_type::first);
  if (known == phases.end())
    phases.emplace_back(phase, seconds);
  else
    known->second += seconds;
}

Json json_of_move(const MoveJob& job, const MoveReport& report) {
  Json json = {{"taut", TAUT_VERSION},
               {"input", job.input},
               {"motion", job.motion},
               {"metric", null_if_empty(job.metric)},
               {"fields", job.fields},
               {"output", job.output},
               {"fields_out", null_if_empty(job.fields_out)},
               {"metric_out", null_if_empty(job.metric_out)},
               {"pvd", null_if_empty(report.pvd)},
               {"options", options_of(job)},
               {"ended", null_if_empty(report.ended)}};
  json["steps"] = Json::array();
  for (const MoveStep& step : report.steps) json["steps"].push_back(json_of_step(step));
  json["totals"] = totals_of(report);
  return json;
}

}  // namespace taut::program
