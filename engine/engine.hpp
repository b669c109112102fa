// SPDX-License-Identifier: BSD-3-Clause
//
// The type-erased boundary between the driver, which knows no `Real`, and the numerical code, which is compiled
// once per precision. Everything here is plain data or an abstract class; numbers cross as text that reads back
// exactly.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/geometry.hpp"
#include "engine/metrics/description.hpp"
#include "mechanics/model/data.hpp"
#include "methods/contract/description.hpp"
#include "problems/description.hpp"
#include "support/watch.hpp"

namespace kreisel {

/// A measured number: `value` rounded to double for sorting and plotting, `text` the shortest decimal (double) or
/// 36 digits (quad) that reads back exactly. Never NaN or infinite: values that could not be measured are absent.
struct Number {
    double value = 0;
    std::string text = "0";
};

/// One body as reported: x, v in space axes (m, m/s), omega in body axes (rad/s), R row by row, body to space.
struct ReportedBody {
    std::string name;
    std::array<Number, 3> x, v, omega;
    std::array<Number, 9> R;
};

/// What a joint exerts on its second-named body (mechanics/joints/reaction.hpp), N and N m in space axes; of least norm
/// where it is not unique. Apart from it, the force and the torque that keep prescribed coordinates.
struct ReportedReaction {
    std::string joint;
    std::array<Number, 3> force, torque;
    bool unique = true;
    std::optional<Number> driving_force = {}, driving_torque = {};
};

/// A state as reported. `multipliers`: see mechanics/system.hpp; empty where there are none or they are not all
/// unique. For each torsion spring, in the order of the model, the angle and its number of full turns.
struct ReportedState {
    Number t;
    std::vector<ReportedBody> bodies;
    std::vector<Number> multipliers;
    std::vector<std::string> multiplier_names;  ///< "lambda.crank-rod.2 [N m]" of each row
    std::vector<ReportedReaction> reactions;    ///< of each joint
    std::vector<Number> theta = {};             ///< rad
    std::vector<long> turns = {};
};

/// A state that a run goes on from, in place of the start of its problem: bodies, and the full turns of each torsion
/// spring, by the names that they have in samples.
struct BeginState {
    Number t;  ///< s
    std::vector<ReportedBody> bodies;
    std::map<std::string, long> turns;  ///< of "ground-wheel"
};

/// What such a state is to a problem in a formulation.
struct BeginCheck {
    std::string fault;  ///< not empty: no run can go on from it, and why
    double position = 0,
           velocity = 0;  ///< by which it misses the joints: norms of Phi and C v + b, the rows of lengths
    bool drifts = false;  ///< either is above 1e-12 of the mechanism's extent, or of its speed
};

/// A reference solution at a time on the way, with its own uncertainty by metric error.*.
struct ReferenceSample {
    ReportedState state;
    std::map<std::string, Number> error;
};

/// A reference solution at one time, its uncertainty (the larger of the differences between two step sizes and between
/// two routes, in the unit of each `error.*` metric) and the horizon T* up to which all of them agree. Past it the
/// uncertainty may be of any size, and an error is measured only where it is above 100 times that.
struct Reference {
    ReportedState state;
    std::map<std::string, Number>
        error;                 ///< by metric error.*; past the horizon only where both routes reached the end
    double horizon = 0;        ///< s
    std::string route;         ///< how it was computed, for the manifest
    bool interrupted = false;  ///< it was asked to stop; all else is empty
    /// At t_0 + (t_end - t_0) k / K, k = 1 ... K, if it was asked for K samples. `error` then has also the largest
    /// uncertainty of all samples, error.*.max, where each has one: no maximum over the samples is less certain.
    std::vector<ReferenceSample> samples = {};
};

/// The result of checking a reference.
struct ReferenceCheck {
    std::map<std::string, Number> difference;                 ///< the keys of Reference::error, but for those of maxima
    std::string failure;                                      ///< not empty: why there is nothing to compare
    std::vector<std::map<std::string, Number>> samples = {};  ///< the same of each sample
};

/// One cell of an experiment: everything that determines its numbers.
struct Cell {
    std::string problem;
    ParameterValues parameters;  ///< complete, defaults filled in
    std::string formulation;
    std::string method;
    OptionValues options;  ///< complete, defaults filled in
    std::string projection;
    OptionValues projection_options;
    std::shared_ptr<const BeginState> begin = {};  ///< null: the start of the problem, at t = 0
    double t_end = 1;
    long steps = 1;                    ///< of one size; 0 where there is a tolerance
    double tolerance = 0;              ///< to which steps are chosen (methods/control/stepper.hpp); 0: of one size
    std::string controller = "pi";     ///< of steps to a tolerance: elementary, pi, pid
    bool dense = true;                 ///< samples to a tolerance may fall between steps
    long samples = 0;                  ///< K: K+1 equidistant samples are kept; divides `steps` of one size
    std::vector<std::string> metrics;  ///< names or patterns with `*`
    bool timed = false;                ///< measure only time and memory of the steps
    bool repeated = false;             ///< measure, and then the time of the steps by themselves too (Cost::run_s)
    double t_begin() const { return begin ? begin->t.value : 0; }
};

/// The rounds in which the CPU time of cells is taken, each cell in turn: the first by Engine::run, the others by
/// Engine::run_time.
inline constexpr int timing_rounds = 5;

struct Cost {
    long evaluations = 0;            ///< solves of the dynamics inside the steps, or residuals of implicit ones
    long exponentials = 0;           ///< of the group inside the steps, or other maps of local coordinates
    long brackets = 0;               ///< of the algebra inside the steps; closed forms take none
    long newton_iterations = 0;      ///< of implicit steps
    long accepted = 0;               ///< steps
    long rejected = 0;               ///< attempts at steps to a tolerance
    long projection_iterations = 0;  ///< Gauss-Newton iterations, all steps
    long output_evaluations = 0;     ///< solves for start, metrics and samples
    double cpu_s = 0;
    std::optional<double> run_s;   ///< of a timed cell: CPU time of a run, mean of the first round, s
    std::optional<double> step_s;  ///< the same per step, s
    std::optional<double> memory;  ///< of a timed cell: what model, system, method, projection and state occupy, bytes
};

struct Column {
    std::string name, unit;
};

/// Receives the samples of a run, each as soon as it is taken. An exception of an implementation ends the run and
/// passes through it.
class SampleSink {
  public:
    virtual ~SampleSink() = default;
    /// Called once, before the first sample.
    virtual void begin(const std::vector<Column>& columns) = 0;
    /// One sample: numbers separated by commas, one for each column; empty where something could not be measured.
    virtual void add(const std::string& row) = 0;
};

/// The constraint rows of a system and how many of them are independent where it starts. Where rows follow from others
/// the multipliers are not unique: `least_norm` are those of least norm at the end of a run, each row divided by its
/// scale.
struct ConstraintSummary {
    int rows = 0, rank = 0;
    int directions = 0;                  ///< rows that compare directions; the others are lengths. Not in results
    std::vector<std::string> redundant;  ///< the rows that follow from others, by joint
    std::optional<double> condition;     ///< ratio of the extreme pivots of M^{-1/2} C^T, its columns of length 1
    std::vector<Number> least_norm;
    bool has_redundant_rows() const { return rank < rows; }
};

/// A first integral that has changed by more than 1 % of its terms.
struct LostIntegral {
    std::string name;
    double share = 0;  ///< |I - I_0| over the sum of the sizes of its terms
};

/// The result of a cell. `status` is "ok", "skipped", "interrupted", or the name of a Status (lie/status.hpp);
/// `detail` says when and where, in words. A failed cell keeps its measurements up to `t_reached`. A timed cell has no
/// final state: that of ten thousand bodies would fill the results.
struct Outcome {
    std::string status = "ok";
    std::string detail;
    int bodies = 0;
    long steps_done = 0;
    double t_reached = 0;
    std::optional<ReportedState> final;
    ConstraintSummary constraints;
    std::vector<std::pair<std::string, Number>> metrics;
    std::map<std::string, std::string> unmeasured;  ///< metrics structure.* that are not defined, and why
    std::optional<LostIntegral> lost;               ///< the one violated most, at the end
    Cost cost;
};

/// A problem in one formulation.
struct SystemSummary {
    std::string skip_reason;  ///< not empty: the formulation does not apply, and why
    int bodies = 0, velocities = 0;
    ConstraintSummary constraints;
    std::vector<IntegralDescription> integrals;
    std::vector<std::string> warnings;
};

/// An eigenvalue of a linearised motion (1/s).
struct Eigenvalue {
    Number real, imaginary;
    int multiplicity = 1;
};

/// A part of a steady motion: "rotation about (0, 0, 1) through (0, 0, 0)", its rate in rad/s or m/s.
struct MotionPart {
    std::string name;
    Number rate;
    std::string unit;
};

/// Motion near the start of a problem, an equilibrium or a steady motion, on the constraint manifold
/// (engine/linearised/linearise.hpp).
struct Linearisation {
    std::string skip_reason;              ///< not empty: the formulation does not apply, and why
    std::string refusal;                  ///< not empty: there is no linearisation, and why
    std::vector<MotionPart> motion = {};  ///< none at an equilibrium
    Number rate;                          ///< of the motion, or of small ones about an equilibrium (1/s)
    Number residual;    ///< by which the start misses the steady motion (1/s), each unknown in units of the mechanism
    int dimension = 0;  ///< of the constraint manifold in TG
    std::vector<Eigenvalue> eigenvalues = {};    ///< by falling real part; zeros are those of no symmetry
    std::vector<Eigenvalue> of_symmetries = {};  ///< along the orbit of the symmetries, mostly zeros
    double uncertainty = 0;                      ///< difference of two step sizes of the derivatives (1/s)
};

/// How steps of a method treat small rotations about a fixed axis under a torque -J Omega^2 theta
/// (engine/stability/test_rotation.hpp).
struct RotationStability {
    std::string refusal;  ///< not empty: it is not defined, and why
    double limit = 0;     ///< the largest h Omega up to which no step makes them grow
    bool bounded = true;  ///< false: none was found, and `limit` is as far as was seen
    double growth = 0;    ///< |mu| - 1 at h Omega = 1/2, mu the eigenvalue of a step that grows most
};

/// Coefficients of a method: of a stage "a_3", of the step "b", or of a factor of exponentials.
struct SchemeRow {
    std::string label;
    std::vector<std::string> coefficients;  ///< rationals, or decimals
};

/// All numerical code of one precision. Thread-safe: every call builds its own objects. What takes a Watch tells it the
/// share that is done, of its steps or of its time where their sizes are chosen, and 1 where it has come to its end.
class Engine {
  public:
    virtual ~Engine() = default;
    virtual std::vector<ProblemDescription> problems() const = 0;
    virtual std::vector<MethodDescription> methods() const = 0;
    virtual std::vector<ProjectionDescription> projections() const = 0;
    virtual std::vector<FormulationDescription> formulations() const = 0;
    /// In the order in which results hold them.
    virtual std::vector<MetricDescription> metrics() const = 0;

    /// Builds the system. Throws ParameterError if the parameters do not describe a system.
    virtual SystemSummary summary(const std::string& problem, const ParameterValues&,
                                  const std::string& formulation) const = 0;
    /// Whether a problem in a formulation that applies can go on from a state. Throws ParameterError.
    virtual BeginCheck check_begin(const std::string& problem, const ParameterValues&, const std::string& formulation,
                                   const BeginState&) const = 0;
    /// What is drawn of a problem. Throws ParameterError.
    virtual Geometry geometry(const std::string& problem, const ParameterValues&) const = 0;
    /// A method under these options, which may decide its order and its estimate.
    virtual MethodDescription method(const std::string& name, const OptionValues&) const = 0;
    /// The coefficients of a method; none where its family has no such data.
    virtual std::vector<SchemeRow> scheme(const std::string& method) const = 0;
    /// Stability of a method, under its standard options, on the test rotation.
    virtual RotationStability stability(const std::string& method) const = 0;
    /// Why this cell cannot run; empty if it can. It is the same for any number of steps, and for any
    /// tolerance. Throws ParameterError, OptionError.
    virtual std::string skip_reason(const Cell&) const = 0;
    /// Runs one cell. `reference` may be null: then no error.* is measured. `samples` may be null too: samples are then
    /// taken and dropped.
    virtual Outcome run(const Cell&, const Reference* reference, const Watch&, SampleSink* samples) const = 0;
    Outcome run(const Cell& cell, const Reference* reference, const Watch& watch) const {
        return run(cell, reference, watch, nullptr);
    }
    /// A further round of a timed or repeated cell: mean CPU time of its runs, s; nothing if they do not come to the
    /// end.
    virtual std::optional<double> run_time(const Cell&, const Watch&) const = 0;
    /// The reference solution of a problem at `t_end`, and at so many equidistant samples on the way, from its start,
    /// or from `begin` where it is not null; requested only from the quad engine.
    virtual Reference reference(const std::string& problem, const ParameterValues&, const BeginState* begin,
                                double t_end, long samples, const Watch&) const = 0;
    Reference reference(const std::string& problem, const ParameterValues& parameters, double t_end, long samples,
                        const Watch& watch) const {
        return reference(problem, parameters, nullptr, t_end, samples, watch);
    }
    Reference reference(const std::string& problem, const ParameterValues& parameters, double t_end,
                        const Watch& watch) const {
        return reference(problem, parameters, nullptr, t_end, 0, watch);
    }
    /// Compares a reference with a computation of its states by the second route.
    virtual ReferenceCheck check_reference(const std::string& problem, const ParameterValues&, const BeginState* begin,
                                           const Reference&) const = 0;
    ReferenceCheck check_reference(const std::string& problem, const ParameterValues& parameters,
                                   const Reference& reference) const {
        return check_reference(problem, parameters, nullptr, reference);
    }
    /// Linearises the motion at the start of a problem, or at `begin` where it is not null. Throws ParameterError.
    virtual Linearisation linearise(const std::string& problem, const ParameterValues&, const std::string& formulation,
                                    const BeginState* begin) const = 0;
    /// Identifies all code that affects a reference; methods are not part of it.
    virtual std::string reference_digest() const = 0;
};

const Engine& engine_binary64();
const Engine& engine_binary128();

}  // namespace kreisel
