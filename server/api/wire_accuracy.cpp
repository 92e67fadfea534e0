// JSON and CSV of measurements of accuracy.
#include <cmath>
#include <sstream>

#include "server/accuracy/rate.h"
#include "server/api/wire.h"

namespace raywalk::api {
namespace {

using namespace accuracy;
using oracle::Verdict;

RayKind parse_ray_kind(const std::string& name) {
  for (const RayKind kind : kAllRayKinds) {
    if (name == name_of(kind)) return kind;
  }
  throw std::runtime_error("there is no class of rays '" + name + "'");
}

Json rate(u64 count, u64 of) {
  return {{"count", count},
          {"of", of},
          {"ppm", per_million(static_cast<double>(count), of)},
          {"ppm_upper95", upper95_ppm(count, of)}};
}

Json finite_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json to_json(const oracle::UlpHistogram& ulps) {
  return {{"hits", ulps.count()},
          {"p50", finite_or_null(ulps.percentile(0.5))},
          {"p999", finite_or_null(ulps.percentile(0.999))},
          {"max", finite_or_null(ulps.largest())}};
}

Json errors_json(const SweepRow& row) {
  const SweepErrors& e = row.errors;
  const auto verdicts = [&](Verdict verdict) { return rate(e.figures.count(verdict), row.judged); };
  const auto some = [&](const std::optional<u64>& count) { return count ? rate(*count, row.judged) : Json(nullptr); };
  Json t_ulps = to_json(e.figures.t_ulps);
  t_ulps["well_conditioned"] = to_json(e.figures.well_conditioned_t_ulps);
  return {{"judged", row.judged},
          {"wrong", rate(e.wrong, row.judged)},
          {"leaks", verdicts(Verdict::leak)},
          {"false_misses", verdicts(Verdict::false_miss)},
          {"false_hits", verdicts(Verdict::false_hit)},
          {"wrong_ids", verdicts(Verdict::wrong_id)},
          {"near", verdicts(Verdict::near)},
          {"boundary", verdicts(Verdict::boundary)},
          {"ties", verdicts(Verdict::tie)},
          {"double_hits", some(e.double_hits)},
          {"self_hits", some(e.self_hits)},
          {"nan_outputs", rate(e.nan_outputs, row.judged)},
          {"brute_mismatches", e.brute_rays > 0 ? rate(e.brute_mismatches, e.brute_rays) : Json(nullptr)},
          {"t_ulps", t_ulps}};
}

Json to_json(const SweepRow& row) {
  return {{"structure", row.combination.structure_kind},
          {"traversal", row.combination.traversal},
          {"structure_id", row.combination.structure.id},
          {"knobs", api::to_json(row.combination.knobs)},
          {"strict", row.combination.is_strict},
          {"class", name_of(row.kind)},
          {"rays", row.rays},
          {"launch_ms", api::to_json(row.launch_ms)},
          {"mrays_per_s", row.mrays_per_s(row.launch_ms.median)},
          {"mrays_per_s_ci95_low", row.mrays_per_s(row.launch_ms.ci95_high)},
          {"mrays_per_s_ci95_high", row.mrays_per_s(row.launch_ms.ci95_low)},
          {"worst_over_median", row.worst_over_median},
          {"bytes_per_triangle", row.bytes_per_triangle},
          {"steps_per_ray", value_or_null(row.steps_per_ray)},
          {"error", errors_json(row)}};
}

Json to_json(const CaseOutcome& outcome, const std::vector<KindInfo>& kinds) {
  const KindInfo& kind = kind_named(kinds, outcome.technique.structure, "");
  const TraversalInfo& traversal = traversal_named(kind, outcome.technique.traversal, "");
  std::vector<Option> knobs;
  for (const Option& option : traversal.options) {
    if (is_knob(std::string(option.name))) knobs.push_back(option);
  }
  const auto text = [](const std::string& t) { return t.empty() ? Json(nullptr) : Json(t); };
  return {{"number", outcome.number},
          {"title", outcome.title},
          {"structure", kind.name},
          {"traversal", traversal.name},
          {"options", options_json(kind.options, outcome.technique.options)},
          {"knobs", options_json(knobs, outcome.technique.kernel)},
          {"strict", is_strict(outcome.technique)},
          {"rays", outcome.rays},
          {"failures", outcome.failures},
          {"nan_outputs", outcome.nans},
          {"first_failure", text(outcome.first_failure)},
          {"why_not", text(outcome.why_not)},
          {"ms", outcome.ms}};
}

std::string cases_csv(const AccuracyResult& result) {
  std::ostringstream out;
  out << "number,title,structure,traversal,strict,rays,failures,nan_outputs,ms\n";
  for (const CaseOutcome& one : result.cases) {
    out << one.number << ",\"" << one.title << "\"," << one.technique.structure << ',' << one.technique.traversal << ','
        << (is_strict(one.technique) ? "true" : "false") << ',' << one.rays << ',' << one.failures << ',' << one.nans
        << ',' << one.ms << '\n';
  }
  return out.str();
}

}  // namespace

accuracy::AccuracySpec parse_accuracy_spec(const Json& json) {
  AccuracySpec spec;
  spec.scene = json.value("scene", "");
  spec.hard_cases = json.value("hard_cases", spec.scene.empty());
  for (const Json& t : json.value("techniques", Json::array())) {
    spec.techniques.push_back(
        {t.at("structure"), t.at("traversal"), parse_options(t.value("options", Json::object()))});
  }
  for (const Json& set : json.value("knob_sets", Json::array())) spec.knob_sets.push_back(parse_options(set));
  for (const Json& kind : json.at("classes")) spec.classes.push_back(parse_ray_kind(kind));
  spec.rays = json.value("rays", u64{0});
  spec.quick = json.at("quick");
  spec.seed = json.at("seed");
  spec.time_limit_s = json.at("time_limit_s");
  return spec;
}

Json to_json(const accuracy::AccuracySpec& spec) {
  Json json = {{"hard_cases", spec.hard_cases}, {"techniques", Json::array()}, {"classes", Json::array()},
               {"quick", spec.quick},           {"seed", spec.seed},           {"time_limit_s", spec.time_limit_s}};
  if (!spec.scene.empty()) json["scene"] = spec.scene;
  if (spec.rays > 0) json["rays"] = spec.rays;
  for (const SweepTechnique& t : spec.techniques) {
    Json technique = {{"structure", t.structure}, {"traversal", t.traversal}};
    if (!t.options.empty()) technique["options"] = to_json(t.options);
    json["techniques"].push_back(std::move(technique));
  }
  for (const GivenOptions& set : spec.knob_sets) json["knob_sets"].push_back(to_json(set));
  for (const RayKind kind : spec.classes) json["classes"].push_back(name_of(kind));
  return json;
}

Json to_json(const accuracy::AccuracyResult& result, const Job& job, const std::vector<KindInfo>& kinds) {
  Json structures = Json::array(), rows = Json::array(), costs = Json::array(), cases = Json::array();
  for (const StructureRecord& record : result.structures) structures.push_back(to_json(record, kinds));
  for (const SweepRow& row : result.rows) rows.push_back(to_json(row));
  for (const InvalidCost& cost : result.invalid_costs) {
    costs.push_back({{"structure", cost.combination.structure_kind},
                     {"traversal", cost.combination.traversal},
                     {"ratio", cost.ratio}});
  }
  for (const CaseOutcome& outcome : result.cases) cases.push_back(to_json(outcome, kinds));
  return {{"schema_version", 1},
          {"kind", "accuracy"},
          {"id", job.id},
          {"created_at", result.created_at},
          {"machine", to_json(result.machine)},
          {"scene", result.scene ? to_json(SceneEntry{result.scene->info, result.scene}) : Json(nullptr)},
          {"spec", to_json(job.spec)},
          {"structures", structures},
          {"rows", rows},
          {"invalid_costs", costs},
          {"cases", cases},
          {"stop_reason", result.reached_time_limit ? "time_limit" : "completed"},
          {"notes", result.notes}};
}

std::string to_csv(const accuracy::AccuracyResult& result) {
  if (!result.scene) return cases_csv(result);
  std::ostringstream out;
  out.precision(9);
  out << "scene,structure,traversal,structure_id,knobs,strict,class,rays,median_ms,ci95_low_ms,ci95_high_ms,mrays_per_"
         "s,"
         "worst_over_median,bytes_per_triangle,steps_per_ray,judged,wrong,wrong_ppm,wrong_ppm_upper95,leaks,"
         "false_misses,false_hits,wrong_ids,near,boundary,ties,double_hits,self_hits,nan_outputs,brute_rays,"
         "brute_mismatches,t_ulps_p50,t_ulps_p999,t_ulps_max\n";
  const auto number = [](const auto& value) { return value ? Json(*value).dump() : std::string(); };
  for (const SweepRow& row : result.rows) {
    const SweepErrors& e = row.errors;
    const Statistics& s = row.launch_ms;
    const auto& ulps = e.figures.t_ulps;
    out << result.scene->info.name << ',' << row.combination.structure_kind << ',' << row.combination.traversal << ','
        << row.combination.structure.id << ',' << row.combination.changed.substr(!row.combination.changed.empty())
        << ',' << (row.combination.is_strict ? "true" : "false") << ',' << name_of(row.kind) << ',' << row.rays << ','
        << s.median << ',' << s.ci95_low << ',' << s.ci95_high << ',' << row.mrays_per_s(s.median) << ','
        << row.worst_over_median << ',' << row.bytes_per_triangle << ',' << number(row.steps_per_ray) << ','
        << row.judged << ',' << e.wrong << ',' << per_million(static_cast<double>(e.wrong), row.judged) << ','
        << upper95_ppm(e.wrong, row.judged);
    for (const Verdict verdict : {Verdict::leak, Verdict::false_miss, Verdict::false_hit, Verdict::wrong_id,
                                  Verdict::near, Verdict::boundary, Verdict::tie}) {
      out << ',' << e.figures.count(verdict);
    }
    out << ',' << number(e.double_hits) << ',' << number(e.self_hits) << ',' << e.nan_outputs << ',' << e.brute_rays
        << ',' << e.brute_mismatches << ',' << ulps.percentile(0.5) << ',' << ulps.percentile(0.999) << ','
        << ulps.largest() << '\n';
  }
  return out.str();
}

}  // namespace raywalk::api
