// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/rules.hpp"

namespace kreisel {

const std::vector<RuleDescription>& rules_of_meaning() {
    static const std::vector<RuleDescription> rules = {
        {Rule::each_once, "each-once",
         "entries of a list that are written differently mean different things; x and y of a figure do"},
        {Rule::own_name, "own-name", "problems have labels, bodies, joints and figures names of their own"},
        {Rule::separators, "separators", "texts hold no control characters and no line separators beyond ASCII"},
        {Rule::whole_steps, "whole-steps", "a step divides the end time"},
        {Rule::whole_strides, "whole-strides", "the number of samples divides every number of constant steps"},
        {Rule::begin, "begin",
         "`begin` is a sample of the mechanism that its file has and the formulation holds, before `end`"},
        {Rule::finest_level, "finest-level",
         "steps and tolerances of `{\"from\", \"levels\", \"factor\"}` are allowed "
         "up to the last level"},
        {Rule::symmetry, "symmetry", "a matrix of inertia is symmetric, as far as its decimals tell"},
        {Rule::unit_norm, "unit-norm", "a quaternion has norm 1, as far as its decimals tell"},
        {Rule::zipped, "zipped", "axes of one `zip` have equally many values"},
        {Rule::file, "file", "the files that `extends` and `file` name are there, and do not lead back"},
        {Rule::model, "model",
         "parameters describe a mechanism: names that exist, inertias of bodies, a start on the "
         "joints"},
        {Rule::options, "options", "options of a method or projection go together, and with the problem"},
        {Rule::quad, "quad",
         "a program without quad precision computes neither in quad nor the references of `error.*`"},
        {Rule::metric, "metric", "a metric is one of these problems"},
        {Rule::figure_metric, "figure-metric", "a figure draws a metric that the experiment measures"},
        {Rule::figure_selection, "figure-selection", "`select` names what the experiment has, and fits some cell"},
        {Rule::figure_curve, "figure-curve", "`legend` and `order` name curves that the experiment can have"},
        {Rule::figure_body, "figure-body", "a figure draws a body of the problem"},
        {Rule::figure_until, "figure-until", "a figure ends within the run"},
        {Rule::figure_range, "figure-range", "the range of an axis goes from a lower to a higher number"},
    };
    return rules;
}

}  // namespace kreisel
