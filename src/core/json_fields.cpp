// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json_fields.h"

#include "core/file_units.h"
#include "core/json_location.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace agv {
namespace {

std::string rangeText(NumberRange range)
{
    return "must be between " + decimalText(range.least) + " and " + decimalText(range.most);
}

/// Levenshtein distance.
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

/// "; did you mean ...?" when a known key differs by a slip or two.
std::string typoHelp(const std::string& key, const std::vector<std::string>& known)
{
    constexpr std::size_t longestKey = 64; // nobody mistypes a longer one, and the comparison would be slow
    if (key.size() > longestKey)
        return "";
    const auto slips = [&](const std::string& candidate) { return editDistance(key, candidate); };
    const auto nearest = std::min_element(known.begin(), known.end(),
                                          [&](const auto& a, const auto& b) { return slips(a) < slips(b); });
    return slips(*nearest) <= 1 + key.size() / 5 ? "; did you mean \"" + *nearest + "\"?" : "";
}

} // namespace

std::string describe(const Json& json)
{
    if (json.is_string()) {
        const auto& text = json.get_ref<const std::string&>();
        return text.size() <= 40 ? json.dump() : "a text of " + std::to_string(text.size()) + " bytes";
    }
    if (json.is_object())
        return "an object";
    if (json.is_array())
        return "an array";
    std::string text = printJson(json);
    text.pop_back();
    return text;
}

std::optional<long double> readNumber(const Json& json, const std::string& pointer, NumberRange range,
                                      JsonFindings& findings)
{
    if (!json.is_number()) {
        findings.errors.push_back({pointer, "must be a number (is " + describe(json) + ")"});
        return std::nullopt;
    }
    const auto value = json.get<long double>();
    if (!(value >= range.least && value <= range.most)) {
        findings.errors.push_back({pointer, rangeText(range) + " (is " + describe(json) + ")"});
        return std::nullopt;
    }
    return value;
}

JsonFields::JsonFields(const Json& json, std::string pointer, JsonFindings& findings)
    : m_json(json),
      m_pointer(std::move(pointer)),
      m_findings(findings),
      m_known{"comment"}
{
    if (!json.is_object())
        m_findings.errors.push_back({m_pointer, "must be an object in braces (is " + describe(json) + ")"});
}

std::string JsonFields::pointerTo(std::string_view key) const { return m_pointer + "/" + pointerToken(key); }

const Json* JsonFields::find(std::string_view key, const char* required)
{
    m_known.emplace_back(key);
    if (!m_json.is_object())
        return nullptr;
    const auto found = m_json.find(std::string(key));
    if (found != m_json.end())
        return &*found;
    if (required != nullptr)
        m_findings.errors.push_back(
            {m_pointer, "the key \"" + std::string(key) + "\" is missing; add " + required});
    return nullptr;
}

std::optional<long double> JsonFields::number(std::string_view key, NumberRange range, bool required)
{
    const Json* const value = find(key, required ? "it with a number" : nullptr);
    return value == nullptr ? std::nullopt : readNumber(*value, pointerTo(key), range, m_findings);
}

double JsonFields::thousandths(std::string_view key, NumberRange range, std::optional<double> fallback)
{
    const auto value = number(key, range, !fallback);
    return value ? fromThousandths(*value) : fallback.value_or(0.0);
}

double JsonFields::degrees(std::string_view key, std::optional<double> fallback)
{
    const auto value = number(key, {-360, 360}, !fallback);
    return value ? fromDegrees(*value) : fallback.value_or(0.0);
}

int JsonFields::integer(std::string_view key, int least, int most, std::optional<int> fallback)
{
    const NumberRange range{static_cast<double>(least), static_cast<double>(most)};
    const auto value = number(key, range, !fallback);
    if (!value)
        return fallback.value_or(least);
    if (*value != std::floor(*value)) {
        error(key, "must be a whole number (is " + describe(*find(key)) + ")");
        return fallback.value_or(least);
    }
    return static_cast<int>(*value);
}

bool JsonFields::boolean(std::string_view key, bool fallback)
{
    const Json* const value = find(key);
    if (value == nullptr || value->is_boolean())
        return value == nullptr ? fallback : value->get<bool>();
    error(key, "must be true or false (is " + describe(*value) + ")");
    return fallback;
}

std::string JsonFields::text(std::string_view key, std::optional<std::string> fallback)
{
    const Json* const value = find(key, fallback ? nullptr : "it with a text in quotation marks");
    if (value != nullptr && value->is_string())
        return value->get<std::string>();
    if (value != nullptr)
        error(key, "must be a text in quotation marks (is " + describe(*value) + ")");
    return std::move(fallback).value_or("");
}

const Json* JsonFields::object(std::string_view key)
{
    const Json* const value = find(key);
    if (value == nullptr || value->is_object())
        return value;
    error(key, "must be an object in braces (is " + describe(*value) + ")");
    return nullptr;
}

const Json* JsonFields::array(std::string_view key)
{
    const Json* const value = find(key);
    if (value == nullptr || value->is_array())
        return value;
    error(key, "must be an array in brackets (is " + describe(*value) + ")");
    return nullptr;
}

void JsonFields::error(std::string_view key, std::string text)
{
    m_findings.errors.push_back({pointerTo(key), std::move(text)});
}

void JsonFields::finish()
{
    if (!m_json.is_object())
        return;
    for (const auto& [key, value] : m_json.items()) {
        if (std::find(m_known.begin(), m_known.end(), key) == m_known.end())
            m_findings.warnings.push_back(
                {pointerTo(key), "this key is unknown and has no effect" + typoHelp(key, m_known)});
    }
}

} // namespace agv
