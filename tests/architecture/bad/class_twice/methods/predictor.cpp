// SPDX-License-Identifier: BSD-3-Clause
namespace kreisel {
namespace {
struct Extrapolation {
    int own;
};
}  // namespace

class Extrapolation : private Base {
    int steps;
};

}  // namespace kreisel
