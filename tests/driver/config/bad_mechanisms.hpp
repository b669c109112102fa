// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace kreisel {

/// Parameters of the problem `multibody` that the reader accepts.
std::string good_mechanism();

/// A value put into the good mechanism, which makes it bad.
struct BadMechanism {
    std::string place;    ///< where the value is put: a JSON pointer below the parameters
    std::string value;    ///< JSON
    std::string pointer;  ///< location of the error, below the parameters
    std::string phrase;   ///< required text of the message
};

const std::vector<BadMechanism>& bad_mechanisms();

}  // namespace kreisel
