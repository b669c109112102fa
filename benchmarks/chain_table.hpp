// SPDX-License-Identifier: BSD-3-Clause
//
// What the console does not show: nanoseconds per body of all contenders side by side, and the growth of its time.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace bench {

/// Slope of log time over log N from N = 8 on, by least squares; NaN with fewer than three sizes.
inline double exponent(const std::map<long, double>& times) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [size, time] : times) {
        if (size < 8) continue;
        const double a = std::log(static_cast<double>(size)), b = std::log(time);
        n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    return n < 3 ? std::nan("") : (n * xy - x * y) / (n * xx - x * x);
}

/// Keeps the least CPU time over the repetitions of every benchmark named contender/N.
class Table : public benchmark::ConsoleReporter {
  public:
    Table() : ConsoleReporter(OO_Tabular) {}

    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
            const std::string& name = run.run_name.function_name;
            const std::size_t slash = name.rfind('/');
            const double time = 1e9 * run.cpu_accumulated_time / static_cast<double>(run.iterations);
            const std::string contender = name.substr(0, slash);
            const auto [at, is_new] = times_[contender].insert({std::stol(name.substr(slash + 1)), time});
            if (!is_new) at->second = std::min(at->second, time);
        }
    }

    void Finalize() override {
        std::map<long, bool> sizes;
        for (const auto& [contender, times] : times_)
            for (const auto& [size, time] : times) sizes[size] = true;
        std::printf("\nns of CPU time per body, least of the repetitions; p: time grows as N^p from N = 8 on\n%-34s",
                    "N");
        for (const auto& [size, there] : sizes) std::printf("%8ld", size);
        std::printf("%8s\n", "p");
        for (const auto& [contender, times] : times_) {
            std::printf("%-34s", contender.c_str());
            for (const auto& [size, there] : sizes) {
                const auto at = times.find(size);
                if (at == times.end())
                    std::printf("%8s", "");
                else
                    std::printf("%8.1f", at->second / static_cast<double>(size));
            }
            std::printf("%8.3f\n", exponent(times));
        }
    }

  private:
    std::map<std::string, std::map<long, double>> times_;
};

}  // namespace bench
