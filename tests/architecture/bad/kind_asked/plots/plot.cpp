// SPDX-License-Identifier: BSD-3-Clause
// A comment may say "scaling".
bool is_timed(const std::string& kind) { return kind == "scaling"; }
