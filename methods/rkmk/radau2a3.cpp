// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the Radau IIA method with 3 stages, order 5, in coordinates around the start of the step, with
// S = sqrt(6):
//   (4 - S)/10 |  (88 - 7 S)/360    (296 - 169 S)/1800  (-2 + 3 S)/225
//   (4 + S)/10 | (296 + 169 S)/1800   (88 + 7 S)/360    (-2 - 3 S)/225
//       1      |    (16 - S)/36        (16 + S)/36           1/9
//   -----------+--------------------------------------------------------
//              |    (16 - S)/36        (16 + S)/36           1/9
// Stiffly accurate and L-stable. Sources: [hairer1996, Sec. IV.5], lift [munthekaas1999].
#include "methods/rkmk/implicit_rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const ImplicitTableau radau2a3{
    .a = {{"0.1968154772236604258683861429918298896006621323", "-0.06553542585019838810852278256960869180124729124",
           "0.02377097434822015242040823210718966300399041085"},
          {"0.3944243147390872769974116714584975806901361801", "0.2920734116652284630205027458970589992882267566",
           "-0.04154875212599793019818600988496744078176818863"},
          {"0.37640306270046727505007544236928079466761257",
           "0.5124858261884216138388134465196080942212763189",
           {1, 9}}},
    .b = {"0.37640306270046727505007544236928079466761257", "0.5124858261884216138388134465196080942212763189", {1, 9}},
    .c = {"0.1550510257216821901802715925294108608034052519", "0.6449489742783178098197284074705891391965947481", 1},
};

KREISEL_METHOD(implicit_rkmk(radau2a3),
               {.name = "rkmk/radau2a3",
                .order = 5,
                .cites = {"hairer1996", "munthekaas1999"},
                .summary = "Munthe-Kaas lift of the Radau IIA method with 3 stages, stiffly accurate",
                .variable_cost = true,
                .form = Form::implicit});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
