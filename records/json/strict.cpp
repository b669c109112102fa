// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/strict.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

using nlohmann::json;

// Builds the value as nlohmann's own builder does, but refuses duplicate keys and deep nesting, and remembers where an
// error occurred as a JSON pointer.
class StrictBuilder final : public nlohmann::json_sax<json> {
  public:
    explicit StrictBuilder(Document& document) : document_(document) {}

    const std::string& error() const { return error_; }

    bool null() override { return place(json(nullptr)) != nullptr; }
    bool boolean(bool value) override { return place(json(value)) != nullptr; }
    bool number_integer(number_integer_t value) override { return place(json(value)) != nullptr; }
    bool number_unsigned(number_unsigned_t value) override { return place(json(value)) != nullptr; }
    bool number_float(number_float_t value, const string_t&) override { return place(json(value)) != nullptr; }
    bool string(string_t& value) override { return place(json(std::move(value))) != nullptr; }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        Frame& frame = frames_.back();
        if (frame.container->contains(name)) {
            frame.key = name;
            error_ =
                message(document_, {pointer(), "each key once", "a second " + in_quotes(name), "", Target::key, 2});
            return false;
        }
        frame.key = std::move(name);
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::detail::exception& error) override {
        // nlohmann counts the bytes read, so the offending one is the last of them.
        const std::size_t byte = position == 0 ? 0 : position - 1;
        if (error.id == 406) {
            const std::size_t start = byte + 1 > token.size() ? byte + 1 - token.size() : 0;
            error_ = message_at(document_, start, pointer(),
                                "expected a number within the range of double precision, got " + token.substr(0, 60));
        } else {
            error_ = message_at(document_, byte, pointer(), "expected well-formed JSON, got " + reason(error.what()));
        }
        return false;
    }

  private:
    struct Frame {
        json* container;
        std::string key;
    };

    json* place(json&& value) {
        if (frames_.empty()) {
            document_.value = std::move(value);
            return &document_.value;
        }
        Frame& frame = frames_.back();
        if (frame.container->is_array()) {
            frame.container->push_back(std::move(value));
            return &frame.container->back();
        }
        json& member = (*frame.container)[frame.key];
        member = std::move(value);
        return &member;
    }

    bool open(json&& container) {
        if (frames_.size() >= deepest_nesting) {
            error_ = message(document_, {pointer(), fmt::format("at most {} nested lists and objects", deepest_nesting),
                                         "a deeper one"});
            return false;
        }
        frames_.push_back({place(std::move(container)), {}});
        return true;
    }

    bool close() {
        frames_.pop_back();
        return true;
    }

    std::string pointer() const {
        std::string path;
        for (const Frame& frame : frames_) {
            const bool last = &frame == &frames_.back();
            if (frame.container->is_array()) {
                // An open element has been placed already; the next one has not.
                path = pointer_below(path, std::to_string(frame.container->size() - (last ? 0 : 1)));
            } else if (!last || !frame.container->empty() || !frame.key.empty()) {
                path = pointer_below(path, frame.key);
            }
        }
        return path;
    }

    // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ...; last read: '...'" without
    // its head and without the bytes of the file, which may not be text at all.
    static std::string reason(const std::string& what) {
        const auto column = what.find(", column ");
        const auto colon = column == std::string::npos ? std::string::npos : what.find(": ", column);
        const std::string text = colon == std::string::npos ? what : what.substr(colon + 2);
        const auto bytes = text.find("; last read: '"), end_of_bytes = text.rfind("'; expected ");
        const bool more = end_of_bytes != std::string::npos && bytes != std::string::npos && end_of_bytes > bytes;
        return text.substr(0, bytes) + (more ? text.substr(end_of_bytes + 1) : "");
    }

    Document& document_;
    std::vector<Frame> frames_;
    std::string error_;
};

void refuse_encoding(const Document& document) {
    const std::string& text = document.text;
    if (text.starts_with("\xEF\xBB\xBF")) {
        throw UsageError(message_at(document, 0, "", "expected UTF-8 text without a byte order mark, got one"));
    }
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        throw UsageError(message_at(document, 0, "", "expected UTF-8 text, got UTF-16"));
    }
    const auto zero = text.find('\0');
    if (zero != std::string::npos) {
        throw UsageError(message_at(document, zero, "", "expected UTF-8 text, got a zero byte"));
    }
}

// The pipe of `kreisel check <(...)` has a writer, and /dev/stdin is open: waiting for them is what was asked for.
bool is_descriptor(const std::filesystem::path& file) {
    const std::string path = std::filesystem::absolute(file).lexically_normal().string();
    return path.starts_with("/dev/") || path.starts_with("/proc/");
}

}  // namespace

Document parse_document(std::string file, std::string text) {
    Document document{std::move(file), std::move(text), nullptr};
    if (document.text.size() > largest_document) {
        throw UsageError(message_at(document, 0, "", "expected at most 8 MB, got more"));
    }
    refuse_encoding(document);
    StrictBuilder builder(document);
    if (!json::sax_parse(document.text, &builder)) { throw UsageError(builder.error()); }
    return document;
}

Document read_document(const std::filesystem::path& file) {
    const std::string kind = what_is_no_file(file);
    if (kind == "a folder" || (!kind.empty() && !is_descriptor(file))) {
        throw UsageError(fmt::format("{}: expected a file, got {}", file.string(), kind));
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) { throw FileError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno))); }
    std::string text(largest_document + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (stream.bad()) { throw FileError(fmt::format("{}: reading failed: {}", file.string(), std::strerror(errno))); }
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return parse_document(file.string(), std::move(text));
}

}  // namespace kreisel
