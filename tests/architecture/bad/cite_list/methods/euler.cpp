// SPDX-License-Identifier: BSD-3-Clause
const Description euler{.name = "rkmk/euler", .cites = {"known1900", "unknown"}};
