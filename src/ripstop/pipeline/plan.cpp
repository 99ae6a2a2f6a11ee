#include "ripstop/pipeline/plan.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/io/print/pdf.h"
#include "ripstop/measure/judge.h"
#include "ripstop/pattern/cut/cut_check.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/flatten/strain_maps.h"
#include "ripstop/pipeline/flight/compensate.h"
#include "ripstop/pipeline/read/envelope_faults.h"
#include "ripstop/pipeline/read/own_meshes.h"
#include "ripstop/pipeline/read/tile_fabrics.h"
#include "ripstop/pipeline/redesign/propose_redesign.h"
#include "ripstop/plan_folder/cut_files.h"
#include "ripstop/plan_folder/directory.h"
#include "ripstop/plan_folder/read_cut_plan.h"
#include "ripstop/plan_folder/update_folder.h"
#include "ripstop/report/figures/wide_pieces.h"
#include "ripstop/report/words/inflated_says.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;
using Kind = PlanMessage::Kind;

/// Where an envelope came from.
struct Source {
    std::string file, sha256;
};

/// The steps of `plan_envelope` after the envelope has been read.
class Planner {
  public:
    Planner(const Job& job, const PlanWatch& watch) : job_(job), watch_(watch) {}

    Plan plan(EnvelopeInput input, const Source& source) {
        const EnvelopeCheck check = judge_input(input, {job_.read.seam_tolerance, job_.read.only.empty(), job_.accept});
        begin(PlanStage::flatten);
        Plan plan{flattened(input), {}};
        CutPlan& cut = plan.cut;
        cut.input_file = source.file;
        cut.input_sha256 = source.sha256;
        cut.unit = input.unit.unit.name;
        cut.remarks = input.remarks;
        cut.warnings = input.unused;
        if (input.doubt && !input.doubt->is_wrong) cut.warnings.push_back(input.doubt->sentence);
        take_faults(cut, check);
        propose(cut);
        make_pieces_of(plan);
        return plan;
    }

  private:
    void begin(PlanStage stage) const {
        if (watch_.stage) watch_.stage(stage);
    }

    void tell(Kind kind, const std::string& text) const {
        if (watch_.message) watch_.message({kind, text});
    }

    void warn(CutPlan& cut, const std::vector<std::string>& warnings) const {
        for (const std::string& warning : warnings) tell(Kind::warning, warning);
        cut.warnings.insert(cut.warnings.end(), warnings.begin(), warnings.end());
    }

    CutPlan flattened(EnvelopeInput& input) const {
        const FlattenOptions options{job_.method, *job_.fabric, *job_.tolerances, job_.threads, watch_.progress};
        CutPlan cut;
        if (job_.compensate) {
            cut = compensated(input, options);
        } else {
            cut = flatten_envelope(input.envelope, options);
            if (job_.read.remesh.mode == RemeshMode::automatic && prefer_own_meshes(cut, input, options))
                tell(Kind::note, input.remarks.back());
        }
        if (!cut.flight && job_.read.project) cut.flight = input.flight;
        return cut;
    }

    /// Patterns that inflate to the drawn shape, and their state in flight.
    CutPlan compensated(const EnvelopeInput& input, FlattenOptions flattening) const {
        if (!job_.method.starts_with("seam-"))
            throw InputError("only the methods seam-… compensate for strain, not " + job_.method +
                             "; choose one of them to correct the patterns");
        const Flight flight = job_.flight ? job_.flight(input.flight) : input.flight;
        CompensateOptions options{std::move(flattening), {flight.load, flight.rigging}, flight.tapes};
        options.inflate.threads = job_.threads;
        options.flatten.progress = {};
        options.progress = watch_.progress;
        CutPlan cut = compensate(input.envelope, options);
        cut.flight = flight;
        return cut;
    }

    /// Adds what `judge_input` found wrong with the envelope, and reports accepted issues as notes.
    void take_faults(CutPlan& cut, const EnvelopeCheck& check) const {
        const std::size_t told = cut.remarks.size();
        add_faults(cut, check);
        for (std::size_t i = told; i < cut.remarks.size(); ++i) tell(Kind::note, cut.remarks[i]);
    }

    /// Does nothing if the input was only judged: there is no method to try a seam with.
    void propose(CutPlan& cut) const {
        if (job_.method == "given") return;
        constexpr int all = std::numeric_limits<int>::max();
        const Method& method = method_named(job_.method);
        begin(PlanStage::propose);
        if (job_.propose == ProposeScope::automatic && !add_proposals(cut, method, job_.threads, {}, watch_.progress))
            tell(Kind::information, "Too many tiles fail to propose seams for them; --propose all tries every one");
        if (job_.propose == ProposeScope::all) add_proposals(cut, method, job_.threads, {all, all}, watch_.progress);
        if (!job_.propose_merges) return;
        begin(PlanStage::propose_merges);
        cut.merges = propose_merges(cut, method, job_.threads, watch_.progress);
    }

    void make_pieces_of(Plan& plan) const {
        begin(PlanStage::pieces);
        PieceOptions options = job_.pieces;
        if (options.revision.empty()) options.revision = plan.cut.input_sha256.substr(0, 8);
        std::vector<PatternPiece> pieces = make_pieces(plan.cut, options, job_.threads);
        warn(plan.cut, judge_cut_lines(plan.cut, pieces, job_.allowance_fit, job_.threads));
        plan.pieces = make_piece_set(plan.cut, std::move(pieces), options.revision);
        warn(plan.cut, too_wide_pieces(plan.pieces));
    }

    const Job& job_;
    const PlanWatch& watch_;
};

bool has_wrong_unit(const CutPlan& cut) {
    return std::any_of(cut.findings.begin(), cut.findings.end(),
                       [](const Finding& finding) { return finding.code == "unit"; });
}

/// Drops the PDF if nobody could print it. Returns a warning that says so.
std::vector<std::string> leave_out_unprintable(WriteOptions& writing, const Plan& plan) {
    const auto pdf = std::find(writing.formats.begin(), writing.formats.end(), "pdf");
    if (pdf == writing.formats.end()) return {};
    if (has_wrong_unit(plan.cut)) {
        writing.formats.erase(pdf);
        return {"no PDF is written: the unit is wrong"};
    }
    try {
        require_printable(plan.pieces.pieces, writing.files.paper);
    } catch (const InputError& error) {
        writing.formats.erase(pdf);
        return {"no PDF is written: " + std::string(error.what())};
    }
    return {};
}

}  // namespace

Job completed(Job job) {
    const std::optional<Project>& project = job.read.project;
    if (!job.read.unit && project && project->unit)
        job.read.unit = LengthUnit{*project->unit, metres_per_unit(*project->unit)};
    job.read.size_is_meant = job.read.size_is_meant || (project && project->size_is_meant);
    if (job.read.layers.empty() && project) job.read.layers = project->layers;
    if (!job.seam_tolerance && project) job.seam_tolerance = project->seam_tolerance;
    if (job.seam_tolerance) job.read.seam_tolerance = *job.seam_tolerance;
    if (project) job.accept.insert(job.accept.end(), project->accept.begin(), project->accept.end());
    if (!job.fabric) job.fabric = envelope_fabric(job.fabric_name, project);
    job.read.fabric = *job.fabric;
    if (!job.tolerances) {
        job.tolerances = tolerances_of(*job.fabric);
        if (project) job.tolerances = tolerances(*project, *job.tolerances);
    }
    job.read.remesh.length_tolerance = job.tolerances->length;
    return job;
}

bool Plan::is_good() const {
    return cut.manufacturable() && (!cut.inflated || flies_as_drawn(cut));
}

Plan plan_envelope(const fs::path& file, const Job& given, const PlanWatch& watch) {
    const Job job = completed(given);
    if (watch.stage) watch.stage(PlanStage::read);
    ReadOptions options = job.read;
    options.meshing.progress = watch.progress;
    options.doubts = [&](const UnitDoubt& doubt) {
        if (watch.message) watch.message({Kind::warning, doubt.sentence});
    };
    EnvelopeInput input = read_input(file, options);
    if (watch.read) watch.read(input);
    return Planner(job, watch).plan(std::move(input), {file.filename().string(), sha256_of_file(file)});
}

Plan plan_envelope(Envelope envelope, const Job& given, const PlanWatch& watch) {
    const Job job = completed(given);
    if (watch.stage) watch.stage(PlanStage::read);
    EnvelopeInput input;
    input.envelope = std::move(envelope);
    if (job.read.project) input.flight = job.read.project->flight;
    remesh_input(input, job.read);
    if (watch.read) watch.read(input);
    return Planner(job, watch).plan(std::move(input), {});
}

std::vector<std::string> write_plan(const fs::path& folder, const Plan& plan, const WriteOptions& options) {
    WriteOptions writing = options;
    const std::vector<std::string> warnings = leave_out_unprintable(writing, plan);
    const std::vector<StrainMap> strains = measure_strain_maps(plan.cut, options.threads);
    if (warnings.empty()) {
        write_directory(folder, plan.cut, plan.pieces, writing, strains);
    } else {
        CutPlan warned = plan.cut;
        warned.warnings.insert(warned.warnings.end(), warnings.begin(), warnings.end());
        write_directory(folder, warned, plan.pieces, writing, strains);
    }
    return warnings;
}

Plan read_plan(const fs::path& folder) {
    const Unchanged read({folder / "report.json", folder / "flat" / "sewing.json"});
    CutPlan cut = read_cut_plan(folder);
    return {std::move(cut), read_pieces_of(folder), read};
}

void update_plan(const fs::path& folder, const Plan& plan, const WriteOptions& options) {
    if (!plan.cut.inflated || !plan.folder)
        throw std::invalid_argument("update_plan: the plan is not inflated, or was not read from a folder");
    write_inflated(folder, plan.cut, plan.pieces.pieces, measure_strain_maps(plan.cut, options.threads), *plan.folder,
                   options.reproducible);
}

}  // namespace ripstop
