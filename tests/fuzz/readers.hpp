// SPDX-License-Identifier: BSD-3-Clause
//
// What kreisel reads from files, as functions of a text that may be anything. Whatever it is, it is read or refused;
// another exception than those of a refusal is let through, and is a fault of the reader.
#pragma once

#include <map>
#include <string>

namespace kreisel {

/// Whether a text was taken.
enum class Reading { taken, refused };

/// Readers by name, which is also that of the folder with their corpus: config, mechanism (JSON), robot (URDF), journal
/// (a line), reference, manifest, table (results.csv).
const std::map<std::string, Reading (*)(const std::string& text)>& readers();

}  // namespace kreisel
