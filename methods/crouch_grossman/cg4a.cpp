// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch-Grossman method of order 4 with five stages, and an embedded solution of order 3 with one stage more, which
// only attempts take.
//   0        |
//   0.817723 |  0.817723
//   0.385974 |  0.319988   0.065986
//   0.324229 |  0.921442   0.499786  -1.096998
//   0.876890 |  0.355236   0.239096   1.391857  -1.109298
//   0.174320 |  0.025553   0.041411   0.032742   0.032173   0.042440
//   ---------+-----------------------------------------------------------------
//   b        |  0.137083  -0.018370   0.739781  -0.190714   0.332220
//   b^       |  0.078610  -0.079339   0.323289   0.251755   0.404606   0.021078
// Source: [jackiewicz2000], printed there with 16 decimals. The decimals beyond the 16th are ours: the 13 conditions of
// order 4 for the 15 coefficients, solved again from the printed table to a residual below 1e-40 with corrections of
// least norm (none above 4e-17). The embedded solution is ours too. On the five stages there is none but b: it is a
// double root of the conditions of order 3. With a sixth stage, the five conditions leave the squares of the 11 new
// coefficients to be made small. tools/solve-crouch-grossman prints them all.
#include "methods/crouch_grossman/crouch_grossman.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau cg4a{
    .a = {{},
          {"0.81772279881248518386438341584772319266074844"},
          {"0.31998763754764268140960925832903477034408743", "0.06598642635560218735460322866733355427145820"},
          {"0.92144171944649461260295561444796689455082289", "0.49978577767735729863058062244163890330738958",
           "-1.09699844483715820771826681841610947564066973"},
          {"0.35523585590233220105415681944712091648052075", "0.23909583723073256958529913069514242797477497",
           "1.39185657242032459428673699011534979185995269", "-1.10929793921134651058417724992621633024718977"},
          {"0.02555300321419181239850313168306478162849613", "0.04141146209665968646024939868480467332032463",
           "0.03274240770074959006759360503332776941709588", "0.03217332154577839844047367460244744419977109",
           "0.04243980851410793510293483668478238535010832"}},
    .b = {"0.13708315206307553702959477356769353487833414", "-0.01836985315640201911261088774542920720619092",
          "0.73978139853707799892914361649066248430277041", "-0.19071425655058889669774657703342479752239558",
          "0.33221955910683737985161907472049798554748194", 0},
    .b_hat = {"0.07860970915921448874941662763412910745799002", "-0.07933857478182002394618706283203116708330878",
              "0.32328944126411271297811032856926666885974400", "0.25175525368531643840016131884409813566087706",
              "0.40460574450335598736901290743150634377315537", "0.02107842616982039644948588035303091133154234"},
};

KREISEL_METHOD(crouch_grossman(cg4a), {.name = "crouch_grossman/cg4a",
                                       .order = 4,
                                       .cites = {"jackiewicz2000"},
                                       .summary = "Crouch-Grossman method of order 4 with five stages; pair 4(3)",
                                       .estimate = 4});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
