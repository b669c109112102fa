// SPDX-License-Identifier: BSD-3-Clause
//
// Result folders written by hand, for tables and figures.
#pragma once

#include <stdlib.h>

#include <cmath>
#include <cstdio>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace kreisel::test {

/// A folder that removes itself.
class ResultFolder {
  public:
    ResultFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "kreisel-tables-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~ResultFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name) << text;
    }
    std::string read(const std::string& name) const {
        std::ifstream file(path_ / name);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }
    bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
    void manifest(const nlohmann::json& config) const {
        write("manifest.json", nlohmann::json{{"config", config}}.dump(2));
    }

  private:
    std::filesystem::path path_;
};

/// A result line; `changes` is merged into it.
inline nlohmann::json result_line(const std::string& cell, long steps, double error,
                                  const nlohmann::json& changes = {}) {
    nlohmann::json line = {
        {"cell", cell},
        {"problem", "heavy_top"},
        {"label", "heavy_top"},
        {"parameters", {{"lever", {0, 1, 0}}}},
        {"formulation", "SO3xR3"},
        {"method", "rkmk/rk4"},
        {"options", {{"coordinates", "exp"}}},
        {"order", {{"configuration", 4}, {"velocity", 4}, {"multipliers", 3}}},
        {"projection", "none"},
        {"precision", "double"},
        {"steps", steps},
        {"h", 1.0 / static_cast<double>(steps)},
        {"t_end", 1.0},
        {"status", "ok"},
        {"final",
         {{"t", 1.0},
          {"bodies", {{{"x", {0, 1, 0}}, {"v", {0, 0, 1}}, {"omega", {0, 1, 0}}}}},
          {"multipliers", {1, 2, 2}}}},
        {"metrics", {{"error.position", error}, {"invariant.energy", 1e-3}, {"invariant.energy.relative", 1e-4}}},
        {"reference", {{"error", {{"error.position", 1e-25}}}, {"horizon", 10}}},
        {"cost", {{"evaluations", 4 * steps}, {"projection_iterations", 0}}}};
    if (!changes.is_null()) { line.merge_patch(changes); }
    return line;
}

/// Lines of a method of order `order` at N = 64 ... 2048.
inline std::string convergence_lines(int order, const nlohmann::json& changes = {}, int first_cell = 0) {
    std::string text;
    for (int k = 0; k < 6; ++k) {
        const long steps = 64L << k;
        const double error = std::pow(1.0 / static_cast<double>(steps), order);
        char cell[17];
        std::snprintf(cell, sizeof cell, "%016x", static_cast<unsigned>(first_cell + k));
        text += result_line(cell, steps, error, changes).dump() + "\n";
    }
    return text;
}

/// A top that turns about z with its mass centre on a circle; defects growing like t^2, energy like t.
inline std::string trajectory_text(int samples = 50) {
    std::ostringstream text;
    text
        << "t [s],top.x1 [m],top.x2 [m],top.x3 [m],top.R11 [1],top.R12 [1],top.R13 [1],top.R21 [1],top.R22 [1],top.R23 "
           "[1],"
           "top.R31 [1],top.R32 [1],top.R33 [1],top.v1 [m/s],top.v2 [m/s],top.v3 [m/s],top.omega1 [rad/s],top.omega2 "
           "[rad/s],top.omega3 [rad/s],lambda.pin.1 [N],lambda.pin.2 [N],lambda.pin.3 [N],"
           "defect.position [m],defect.position.max [m],"
           "invariant.energy [J],invariant.energy.max [J]\n";
    text.precision(17);
    for (int i = 0; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples, c = std::cos(t), s = std::sin(t);
        text << t << ',' << -s << ',' << c << ",0," << c << ',' << -s << ",0," << s << ',' << c << ",0,0,0,1," << -c
             << ',' << -s << ",0,0,0,1,,,," << 1e-6 * t * t << ',' << 1e-6 * t * t << ',' << -1e-3 * t << ','
             << 1e-3 * t << '\n';
    }
    return text.str();
}

}  // namespace kreisel::test
