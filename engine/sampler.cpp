// SPDX-License-Identifier: BSD-3-Clause
#include "engine/sampler.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Sampler::Sampler(const Cell& cell, Simulation& simulation, const Sampled& sources, Between between, SampleSink* sink)
    : cell_(cell),
      simulation_(simulation),
      sources_(sources),
      samples_(sources, sink),
      between_(between),
      before_(simulation.state()),
      inside_(before_),
      t_begin_(simulation.time()),
      t_end_(decimal(cell.t_end)) {
    if (between == Between::ends) interpolant_.emplace(simulation.system());
}

Real Sampler::next() const {
    if (taken_ == 0 || taken_ >= cell_.samples) return taken_ == 0 ? t_begin_ : t_end_;
    return t_begin_ + (t_end_ - t_begin_) / Real(cell_.samples) * Real(taken_);
}

void Sampler::begin(Observation& start) {
    taken_ = 0;
    take(start, simulation_.multipliers());
}

void Sampler::remember() {
    if (between_ == Between::none) return;
    before_ = simulation_.state();
    t_before_ = simulation_.time();
}

void Sampler::between(Observation& now) {
    const Real end = simulation_.time(), h = end - t_before_;
    if (between_ == Between::none || !(next() < end)) return;
    Status status = Status::ok;
    if (interpolant_) status = interpolant_->set(t_before_, h, before_.data(), simulation_.state().data());
    for (Real t = next(); t < end; t = next()) {
        if (status != Status::ok) {
            samples_.leave_out(), ++taken_;
            continue;
        }
        find_inside(t, h);
        now.move_to(t, inside_.data());
        sources_.step_metrics.look(now);
        sources_.integral_metrics.look(now);
        take(now, nullptr);  // the method's own multipliers are those of the end of the step
    }
}

void Sampler::find_inside(const Real& t, const Real& h) {
    const Real theta = (t - t_before_) / h;
    if (interpolant_)
        interpolant_->at(theta, inside_.data());
    else
        simulation_.interpolate(theta, h, before_.data(), inside_.data());
}

bool Sampler::due(long steps_done) const {
    if (cell_.steps > 0) return steps_done % (cell_.steps / cell_.samples) == 0;
    return simulation_.time() == next();
}

void Sampler::at_end(long steps_done, Observation& now) {
    if (due(steps_done)) take(now, simulation_.multipliers());
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
