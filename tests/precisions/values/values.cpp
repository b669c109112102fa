// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per precision.
#include "tests/precisions/values/values.hpp"

#include <random>

#include "lie/chart.hpp"
#include "lie/pair.hpp"
#include "lie/power.hpp"
#include "lie/rn.hpp"
#include "lie/se3.hpp"

namespace {

using namespace kreisel;

class Recorder {
  public:
    Recorder(std::vector<Value>& values, std::string group) : values_(values), group_(std::move(group)) {}
    void add(const std::string& map, const VecX& x) {
        for (const Real& entry : x) {
            const double high = to_double(entry);
            values_.push_back({group_ + ", " + map, high, to_double(entry - high)});
        }
    }

  private:
    std::vector<Value>& values_;
    std::string group_;
};

/// All maps at u and v.
void record(const Group& G, const VecX& u, const VecX& v, const std::string& label, std::vector<Value>& values) {
    Recorder recorder(values, label);
    VecX e(G.size()), a(G.size()), b(G.size()), x(G.dim());
    G.identity(e.data());
    G.append_exp(e.data(), u.data(), a.data()), recorder.add("exp", a);
    G.append_cay(e.data(), u.data(), b.data()), recorder.add("cay", b);
    G.log(a.data(), x.data()), recorder.add("log", x);
    G.Ad(a.data(), v.data(), x.data()), recorder.add("Ad", x);
    G.bracket(u.data(), v.data(), x.data()), recorder.add("bracket", x);
    G.dexp(u.data(), v.data(), x.data()), recorder.add("dexp", x);
    G.dexpinv_left(u.data(), v.data(), x.data()), recorder.add("dexpinv", x);
    G.dcayinv_left(u.data(), v.data(), x.data()), recorder.add("dcayinv", x);
    TruncatedExpChart(G, 6).pull_back(u.data(), v.data(), x.data()), recorder.add("dexpinv of six brackets", x);
    G.multiply(a.data(), b.data(), e.data()), recorder.add("product", e);
    G.inverse(e.data(), e.data()), recorder.add("inverse", e);
}

}  // namespace

#if KREISEL_QUAD
std::vector<Value> values_binary128() {
#else
std::vector<Value> values_binary64() {
#endif
    const Power<SO3> rotations(1);
    const Power<SE3> displacements(1);
    const Power<Pair<Rn<3>, SO3>> poses(1);
    const std::pair<const char*, const Group*> groups[] = {
        {"SO(3)", &rotations}, {"SE(3)", &displacements}, {"R^3 x SO(3)", &poses}};
    std::mt19937 engine(31);
    const auto number = [&] { return static_cast<double>(engine() % 2048) / 1024 - 1; };
    std::vector<Value> values;
    for (const auto& [name, group] : groups)
        for (const double size : {0.0, 0x1p-27, 0x1p-10, 0.25, 1.0, 1.75})
            for (int i = 0; i < 10; ++i) {
                VecX u(group->dim()), v(group->dim());
                for (Real& x : u) x = size * number();
                for (Real& x : v) x = number();
                record(*group, u, v, std::string(name) + " at " + std::to_string(size), values);
            }
    return values;
}
