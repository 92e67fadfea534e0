// Results of benchmarks as JSON and CSV.
#include <cmath>
#include <sstream>

#include "server/api/wire.h"

namespace raywalk::api {

Json to_json(const Statistics& s) {
  return {
      {"median", s.median},   {"mean", s.mean}, {"sd", s.sd},   {"mad", s.mad},           {"min", s.min},
      {"p5", s.p5},           {"p95", s.p95},   {"p99", s.p99}, {"ci95_low", s.ci95_low}, {"ci95_high", s.ci95_high},
      {"samples", s.samples}, {"discarded", 0}, {"failed", 0},  {"unstable", s.unstable}};
}

namespace {

Json to_json(const RayVerdicts& v) {
  return {{"rays", v.rays},
          {"judged", v.judged},
          {"right", v.right},
          {"boundary", v.boundary},
          {"near", v.near},
          {"wrong", v.wrong()},
          {"leaks", v.leaks},
          {"false_misses", v.false_misses},
          {"false_hits", v.false_hits},
          {"wrong_ids", v.wrong_ids},
          {"self_hits", v.self_hits},
          {"reference_wrong", v.reference_wrong}};
}

Json to_json(const ErrorFigures& e) {
  const double rmse = e.image_rmse();
  return {{"reference", e.reference},
          {"frames", e.frames},
          {"pixels", e.pixels},
          {"id_mismatches", e.id_mismatches},
          {"id_mismatch_ppm", e.mismatch_ppm()},
          {"id_mismatch_ppm_upper95", e.mismatch_ppm_upper95()},
          {"ties", e.ties},
          {"image_rmse", rmse},
          {"image_psnr_db", rmse > 0 ? Json(-20.0 * std::log10(rmse)) : Json(nullptr)},
          {"image_ssim", value_or_null(e.image_ssim())},
          {"image_flip_mean", value_or_null(e.image_flip_mean())},
          {"image_flip_p99", value_or_null(e.image_flip_p99())},
          {"image_flip_max", value_or_null(e.image_flip_max())},
          {"changed_pixels_ppm", value_or_null(e.changed_pixels_ppm())},
          {"primary_rays", to_json(e.primary)},
          {"shadow_rays", e.shadow.rays > 0 ? to_json(e.shadow) : Json(nullptr)}};
}

/// Options as a request would give them; `traversal` has those of the candidates.
Json to_json(const KnobChoice& choice, const TraversalInfo& traversal) {
  Json candidates = Json::array();
  for (const Candidate& one : choice.candidates) {
    candidates.push_back({{"kernel", options_json(traversal.options, one.kernel)},
                          {"name", one.name},
                          {"frame_ms", one.frame_ms},
                          {"wrong", one.checked ? Json(one.checked->wrong) : Json(nullptr)},
                          {"rays", one.checked ? Json(one.checked->rays) : Json(nullptr)}});
  }
  return {{"candidates", candidates}, {"chosen", choice.chosen}, {"reason", choice.reason}};
}

Json gate_json(const ResultRow& row, const TraversalInfo& traversal) {
  const Gate& gate = row.gate;
  return {{"tier", gate.terms.tier.empty() ? Json(nullptr) : Json(gate.terms.tier)},
          {"status", gate.is_open ? "open" : "closed"},
          {"limit_ppm", value_or_null(gate.terms.limit_ppm)},
          {"wrong", row.error.wrong_rays()},
          {"rays", row.error.checked_rays()},
          {"wrong_ppm", row.error.wrong_ppm()},
          {"wrong_ppm_upper95", row.error.wrong_ppm_upper95()},
          {"reason", gate.reason},
          {"choice", gate.choice ? to_json(*gate.choice, traversal) : Json(nullptr)}};
}

Json to_json(const SensorRange& range) {
  return {{"min", range.min}, {"median", range.median}, {"max", range.max}};
}

Json to_json(const TelemetrySummary& t) {
  return {{"core_clock_mhz", to_json(t.core_clock_mhz)},
          {"memory_clock_mhz", to_json(t.memory_clock_mhz)},
          {"power_w", to_json(t.power_w)},
          {"power_limit_w", t.power_limit_w},
          {"temperature_c", to_json(t.temperature_c)},
          {"throttle_reasons", t.throttle_reasons}};
}

Json to_json(const Throughput& t) {
  return {{"frames_per_launch", t.frames_per_launch},
          {"frame_ms", api::to_json(t.frame_ms)},
          {"mrays_per_s", t.mrays_per_s}};
}

Json kernel_json(const ResultRow& row, const TraversalInfo& traversal) {
  if (!row.kernel) return nullptr;
  const KernelFigures& k = *row.kernel;
  return {{"options", options_json(traversal.options, row.kernel_options)},
          {"registers", k.registers},
          {"local_bytes", k.local_bytes},
          {"shared_bytes", k.shared_bytes},
          {"threads_per_block", k.threads_per_block},
          {"blocks_per_multiprocessor", k.blocks_per_multiprocessor},
          {"occupancy", k.occupancy},
          {"binary_bytes", k.binary_bytes}};
}

Json to_json(const ResultRow& row, const std::vector<KindInfo>& kinds) {
  const TraversalInfo& traversal = traversal_named(kind_named(kinds, row.structure, ""), row.traversal, "");
  return {{"structure", row.structure},
          {"traversal", row.traversal},
          {"structure_id", row.structure_id},
          {"mode", mode_name(row.mode)},
          {"frame_ms", api::to_json(row.frame_ms)},
          {"mrays_per_s", row.mrays_per_s},
          {"rays_per_frame", row.rays_per_frame},
          {"steps_per_ray", value_or_null(row.steps_per_ray)},
          {"tests_per_ray", value_or_null(row.tests_per_ray)},
          {"frame_times_ms", row.frame_times_ms},
          {"kernel_options", options_json(traversal.options, row.kernel_options)},
          {"kernel", kernel_json(row, traversal)},
          {"throughput", row.throughput ? to_json(*row.throughput) : Json(nullptr)},
          {"error", to_json(row.error)},
          {"gate", gate_json(row, traversal)}};
}

/// A field with commas in it.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

Json to_json(const BenchmarkResult& result, const Job& job, const std::vector<KindInfo>& kinds) {
  Json structures = Json::array(), rows = Json::array();
  for (const StructureRecord& record : result.structures) structures.push_back(to_json(record, kinds));
  for (const ResultRow& row : result.rows) rows.push_back(to_json(row, kinds));
  return {{"schema_version", 1},
          {"id", job.id},
          {"created_at", result.created_at},
          {"machine", to_json(result.machine)},
          {"scene", to_json(SceneEntry{result.scene->info, result.scene})},
          {"spec", to_json(job.spec)},
          {"structures", structures},
          {"rows", rows},
          {"telemetry", result.telemetry ? to_json(*result.telemetry) : Json(nullptr)},
          {"stop_reason", result.reached_time_limit ? "time_limit" : "completed"},
          {"notes", result.notes}};
}

std::string to_csv(const BenchmarkResult& result) {
  std::ostringstream out;
  out << "scene,structure,traversal,structure_id,mode,median_ms,mean_ms,sd_ms,min_ms,p95_ms,ci95_low_ms,ci95_high_ms,"
         "samples,unstable,mrays_per_s,rays_per_frame,steps_per_ray,tests_per_ray,reference,id_mismatch_ppm,ties,"
         "image_rmse,image_ssim,image_flip_mean,image_flip_p99,image_flip_max,changed_pixels_ppm,options,registers,"
         "local_bytes,shared_bytes,occupancy,frames_per_launch,launch_median_ms,"
         "launch_mrays_per_s,tier,gate,limit_ppm,wrong,checked_rays,wrong_ppm,wrong_ppm_upper95,gate_reason\n";
  out.precision(9);
  const auto number = [](const std::optional<double>& v) { return v ? Json(*v).dump() : std::string(); };
  for (const ResultRow& row : result.rows) {
    const Statistics& s = row.frame_ms;
    out << result.scene->info.name << ',' << row.structure << ',' << row.traversal << ',' << row.structure_id << ','
        << mode_name(row.mode) << ',' << s.median << ',' << s.mean << ',' << s.sd << ',' << s.min << ',' << s.p95 << ','
        << s.ci95_low << ',' << s.ci95_high << ',' << s.samples << ',' << (s.unstable ? "true" : "false") << ','
        << row.mrays_per_s << ',' << row.rays_per_frame << ',' << number(row.steps_per_ray) << ','
        << number(row.tests_per_ray) << ',' << row.error.reference << ',' << row.error.mismatch_ppm() << ','
        << row.error.ties << ',' << row.error.image_rmse() << ',' << number(row.error.image_ssim()) << ','
        << number(row.error.image_flip_mean()) << ',' << number(row.error.image_flip_p99()) << ','
        << number(row.error.image_flip_max()) << ',' << number(row.error.changed_pixels_ppm()) << ','
        << row.changed_options.substr(!row.changed_options.empty()) << ',';
    if (const std::optional<KernelFigures>& k = row.kernel) {
      out << k->registers << ',' << k->local_bytes << ',' << k->shared_bytes << ',' << k->occupancy << ',';
    } else {
      out << ",,,,";
    }
    if (const std::optional<Throughput>& t = row.throughput) {
      out << t->frames_per_launch << ',' << t->frame_ms.median << ',' << t->mrays_per_s << ',';
    } else {
      out << ",,,";
    }
    out << row.gate.terms.tier << ',' << (row.gate.is_open ? "open" : "closed") << ','
        << number(row.gate.terms.limit_ppm) << ',' << row.error.wrong_rays() << ',' << row.error.checked_rays() << ','
        << row.error.wrong_ppm() << ',' << row.error.wrong_ppm_upper95() << ',' << quoted(row.gate.reason) << '\n';
  }
  return out.str();
}

}  // namespace raywalk::api
