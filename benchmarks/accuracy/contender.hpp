// SPDX-License-Identifier: BSD-3-Clause
//
// What takes part in `bench_accuracy`: ways to move the heavy top of the literature [bruelscardona2010] from t = 0 to
// 1 s, each at settings from rough to fine.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace accuracy {

/// The fast top: J about the mass centre, which the lever (0, 1, 0) m leads to from the pivot at the origin; at the
/// start R = I.
inline constexpr double mass = 15, gravity = 9.81, t_end = 1;
inline constexpr std::array<double, 3> inertia = {0.234375, 0.46875, 0.234375}, spin = {0, 150, -4.61538};

/// One run at one setting. Whatever a library sets up once, beforehand, is set up when a run is made.
class Run {
  public:
    virtual ~Run() = default;
    /// From t = 0 to t_end; false where the integrator gives up. Called once.
    virtual bool integrate() = 0;
    /// Of the mass centre, m.
    virtual std::array<double, 3> position() const = 0;
    virtual long evaluations() const = 0;  ///< of the right-hand side or of the dynamics; 0: not known
};

struct Contender {
    enum class Kind { kreisel, rival, engine };
    Kind kind;
    std::string name;
    bool by_steps;                 ///< settings are counts of steps, else tolerances
    std::vector<double> settings;  ///< from rough to fine
    std::function<std::unique_ptr<Run>(double setting)> run;
};

inline std::string name(Contender::Kind kind) {
    return kind == Contender::Kind::kreisel ? "kreisel" : kind == Contender::Kind::rival ? "rival" : "engine";
}

/// first, first * factor, ... up to `last`.
inline std::vector<double> ladder(double first, double factor, double last) {
    std::vector<double> settings;
    for (double x = first; factor > 1 ? x <= last * 1.001 : x >= last / 1.001; x *= factor) settings.push_back(x);
    return settings;
}
std::vector<double> step_counts(long first, long last);  ///< whole numbers, by factors of the square root of 2
std::vector<double> tolerances(double first, double last);

/// METHOD[;OPTION=VALUE]:FORMULATION[:PROJECTION], over steps, and over tolerances too where the method has an error
/// estimate. Throws std::exception for a name that is not registered.
std::vector<Contender> kreisel_contenders(const std::string& text);
std::vector<Contender> odeint_contenders();
std::vector<Contender> gsl_contenders();
std::vector<Contender> simbody_contenders();
std::vector<Contender> ida_contenders();
std::vector<Contender> mujoco_contenders();  ///< none where the library was not found

}  // namespace accuracy
