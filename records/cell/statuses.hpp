// SPDX-License-Identifier: BSD-3-Clause
//
// How cells end that no status of a step (lie/status.hpp) describes: one table, from which the campaign takes what it
// writes and what it tries again.
#pragma once

#include <string>
#include <string_view>

namespace kreisel::status {

inline constexpr const char* ok = "ok";
inline constexpr const char* skipped = "skipped";
/// Of a journal line that is not a result: the cell was stopped, and its samples so far are kept in a part.
inline constexpr const char* interrupted = "interrupted";
inline constexpr const char* exception = "exception";
inline constexpr const char* crashed = "crashed";
inline constexpr const char* timeout = "timeout";
inline constexpr const char* out_of_memory = "out_of_memory";
inline constexpr const char* no_reference = "no_reference";

struct Entry {
    const char* name;
    const char* meaning;
    bool has_reason;   ///< written as name(reason)
    bool tried_again;  ///< by --resume: it may be due to limits or to the machine
    bool of_limits;    ///< without the limits of its run it may never end: verify leaves it out
};

inline constexpr Entry table[] = {
    {ok, "all steps were made", false, false, false},
    {skipped, "the combination does not apply", false, false, false},
    {interrupted, "the run was stopped", false, true, false},
    {exception, "something was thrown", false, true, false},
    {crashed, "the cell's process was ended by a signal, or ended itself", true, true, false},
    {timeout, "the cell took more CPU time than --timeout", false, true, true},
    {out_of_memory, "the cell asked for more memory than --max-memory", false, true, true},
    {no_reference, "its reference solution could not be computed", true, true, true},
};

/// "crashed(SIGSEGV)".
inline std::string with_reason(std::string_view name, std::string_view reason) {
    return std::string(name) + "(" + std::string(reason) + ")";
}

/// The entry of a status, with its reason or without; null for those of steps.
const Entry* find(std::string_view status);

inline bool is_tried_again(std::string_view status) {
    const Entry* entry = find(status);
    return entry != nullptr && entry->tried_again;
}

inline bool is_of_limits(std::string_view status) {
    const Entry* entry = find(status);
    return entry != nullptr && entry->of_limits;
}

}  // namespace kreisel::status
