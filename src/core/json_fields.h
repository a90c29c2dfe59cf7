// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json_tree.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace agv {

/// Something wrong or odd at a place of a JSON tree.
struct JsonProblem {
    std::string pointer; ///< RFC 6901
    std::string text;    ///< what is wrong and what to do
};

/// What a reader found: errors and warnings, in any order; the caller sorts them by place.
struct JsonFindings {
    std::vector<JsonProblem> errors;
    std::vector<JsonProblem> warnings;
};

/// Inclusive range of a number as it stands in the file.
struct NumberRange {
    double least;
    double most;
};

/// Reads the members of one JSON object. Every mistake is added to the findings and read as a harmless
/// default, so that one pass finds them all. Keys nobody asked for become warnings in finish().
class JsonFields {
public:
    JsonFields(const Json& json, std::string pointer, JsonFindings& findings);

    const std::string& pointer() const { return m_pointer; }
    std::string pointerTo(std::string_view key) const;
    bool has(std::string_view key) { return find(key) != nullptr; }

    /// The member, or nullptr. With `required` its absence is an error that says what to add.
    const Json* find(std::string_view key, const char* required = nullptr);

    /// Numbers in the unit of the file; a missing key without a default is an error.
    std::optional<long double> number(std::string_view key, NumberRange range, bool required = false);
    /// Thousandths: mm, ms, mm/s in the file; m, s, m/s here.
    double thousandths(std::string_view key, NumberRange range, std::optional<double> fallback);
    double degrees(std::string_view key, std::optional<double> fallback);
    int integer(std::string_view key, int least, int most, std::optional<int> fallback);
    bool boolean(std::string_view key, bool fallback);
    std::string text(std::string_view key, std::optional<std::string> fallback);
    /// An object or array, or nullptr when it is absent or something else.
    const Json* object(std::string_view key);
    const Json* array(std::string_view key);

    void error(std::string_view key, std::string text);
    JsonFindings& findings() { return m_findings; }

    /// Reports the keys nobody asked for.
    void finish();

private:
    const Json& m_json;
    std::string m_pointer;
    JsonFindings& m_findings;
    std::vector<std::string> m_known;
};

/// A number within a range, or an error at `pointer`.
std::optional<long double> readNumber(const Json& json, const std::string& pointer, NumberRange range,
                                      JsonFindings& findings);

/// "a text", "an object", "null", "-5" for messages.
std::string describe(const Json& json);

} // namespace agv
