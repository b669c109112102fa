// SPDX-License-Identifier: BSD-3-Clause
//
// Reference solutions kept as files: a self-contained copy in the result folder, and one in a cache folder that all
// results share. A file records its content, code and time of computation and the error bound, and ends with
// a check sum. A file that does not match is computed again and overwritten. A reference with samples is another
// content than the same without, so that one never stands for the other.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "records/cell/planned.hpp"
#include "support/files.hpp"

namespace kreisel {

/// A reference and the text of its file.
struct StoredReference {
    Reference reference;
    std::string text;
    bool given = false;  ///< by another program: it is kept in results, and in no cache
};

/// `references/<hash>.json`.
std::filesystem::path reference_file(const std::filesystem::path& folder, const std::string& hash);

/// The text of the file that keeps a reference computed at this moment by the code of that digest.
StoredReference stored_reference(const PlannedReference& planned, const Reference& reference,
                                 const std::string& digest);

/// Reads such a text; nothing if it is damaged, or not of this content. `digest`: of code whose digest begins so; empty:
/// of any.
std::optional<StoredReference> read_reference(const std::string& text, const PlannedReference& planned,
                                              const std::string& digest);

/// The same from a file; nothing if it is not there or cannot be read.
std::optional<StoredReference> load_reference(const std::filesystem::path& file, const PlannedReference& planned,
                                              const std::string& digest);

/// The part of a digest that all programs of the same sources have.
std::string digest_of_sources(const std::string& digest);

/// What another results folder has, if it is of the same sources as the code of that digest; nothing if `folder` is
/// empty.
std::optional<StoredReference> given_reference(const std::filesystem::path& folder, const PlannedReference& planned,
                                               const std::string& digest);

/// Whether the text of a reference's file has its sum.
bool is_whole_reference(const std::string& text);

/// A text for each file of the references of a results folder whose sum does not hold. Throws FileError.
std::vector<std::string> reference_damage(const std::filesystem::path& folder);

/// $KREISEL_CACHE (empty: no cache), else $XDG_CACHE_HOME/kreisel, else $HOME/.cache/kreisel, else empty: no cache.
std::filesystem::path default_cache_folder();

class ReferenceStore {
  public:
    /// `cache` and `given` may be empty. `digest` identifies the code that computes references
    /// (Engine::reference_digest). `given`: another results folder, whose references count if they are of the same
    /// sources.
    ReferenceStore(std::filesystem::path results, std::filesystem::path cache, std::string digest,
                   std::filesystem::path given = {})
        : results_(std::move(results)),
          cache_(std::move(cache)),
          digest_(std::move(digest)),
          given_(std::move(given)) {}

    /// From the result folder, else from the one that is given, else from the cache.
    std::optional<StoredReference> find(const PlannedReference& planned) const;
    /// Whether the file in the result folder is there and its sum does not hold.
    bool is_damaged(const PlannedReference& planned) const;
    StoredReference make(const PlannedReference& planned, const Reference& reference) const {
        return stored_reference(planned, reference, digest_);
    }
    /// Held while a reference is computed, so that runs that share a cache, or shards that share a folder, do not all
    /// compute it. Throws FileError.
    ThingLock lock(const PlannedReference& planned) const;
    /// Writes it to both places, where it is not there yet. Throws FileError where the result folder cannot be written;
    /// for a cache that cannot be written the reason is returned, for a note.
    std::string keep(const PlannedReference& planned, const StoredReference& stored) const;

  private:
    std::filesystem::path in_results(const PlannedReference& planned) const;
    /// Named by content and code, so that references of several versions live side by side.
    std::filesystem::path in_cache(const PlannedReference& planned) const;

    std::filesystem::path results_, cache_;
    std::string digest_;
    std::filesystem::path given_;
};

}  // namespace kreisel
