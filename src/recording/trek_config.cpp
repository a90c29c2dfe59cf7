// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/trek_config.h"

#include "recording/number_text.h"
#include "recording/text_lines.h"

#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

namespace agv::recording {

namespace {

constexpr int trekTags = 8;
constexpr int mostTrekId = 255; // as in a plant file
constexpr double mostTrekCoordinate_m = 1e3;
constexpr double mostCorrection_cm = 1e4;
constexpr int mostHistory = 1'000'000;
constexpr double largestTag_m = 1e3;
constexpr double cmPerMetre = 100.0;

int lineAt(std::string_view text, std::ptrdiff_t offset)
{
    const auto end = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text.size());
    return 1 + static_cast<int>(std::ranges::count(text.substr(0, end), '\n'));
}

/// The document's <config>; BadInput names the line.
Result<pugi::xml_node> openConfig(pugi::xml_document& document, std::string_view text, const char* element)
{
    const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
    if (!result)
        return failure(ErrorCode::BadInput,
                       std::to_string(lineAt(text, result.offset)) + ": is not XML: " + result.description());
    const pugi::xml_node config = document.child("config");
    if (!config || !config.child(element))
        return failure(ErrorCode::BadInput,
                       "1: is no settings file of DecaRangeRTLS; expected <config> with <" +
                           std::string(element) + ">");
    return config;
}

/// Reads the attributes of one element; the first that is wrong is the reason to leave it out.
class Attributes {
public:
    explicit Attributes(const pugi::xml_node& element) : m_element(element) {}

    /// 0 when it is left out.
    double number(const char* name, double most)
    {
        const pugi::xml_attribute attribute = m_element.attribute(name);
        if (!attribute)
            return 0.0;
        const auto value = parseNumber(trimmed(attribute.value()));
        if (value && std::abs(*value) <= most)
            return *value;
        wrong(name, "a number within +-" + numberText(most));
        return 0.0;
    }

    int integer(const char* name, int base, int most)
    {
        const std::string_view text = trimmed(m_element.attribute(name).value());
        int value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value, base);
        if (!text.empty() && error == std::errc{} && stop == end && value >= 0 && value <= most)
            return value;
        wrong(name, std::string("a ") + (base == 16 ? "hexadecimal" : "whole") + " number from 0 to " +
                        std::to_string(most));
        return 0;
    }

    std::string label(const std::string& otherwise) const
    {
        const std::string_view text = m_element.attribute("label").value();
        return text.empty() ? otherwise : std::string(text);
    }

    const std::string& reason() const { return m_reason; }

private:
    void wrong(const char* name, const std::string& expected)
    {
        if (m_reason.empty())
            m_reason = std::string("<") + m_element.name() + ">: " + name + " must be " + expected + " (is " +
                       inQuotes(m_element.attribute(name).value()) + ")";
    }

    pugi::xml_node m_element;
    std::string m_reason;
};

std::string correctionName(int tag) { return "t" + std::to_string(tag); }

std::string textOf(const pugi::xml_document& document)
{
    std::ostringstream stream;
    document.save(stream, " ");
    return stream.str();
}

} // namespace

Result<TrekAnchorConfig> readTrekAnchorConfig(std::string_view text)
{
    pugi::xml_document document;
    const auto root = openConfig(document, text, "anc");
    if (!root)
        return std::unexpected(root.error());
    TrekAnchorConfig config;
    std::set<int> used;
    for (const pugi::xml_node& element : root->children("anc")) {
        Attributes attributes(element);
        UwbAnchor anchor;
        anchor.id = attributes.integer("ID", 10, mostTrekId);
        anchor.label = attributes.label("A" + std::to_string(anchor.id));
        anchor.x = attributes.number("x", mostTrekCoordinate_m);
        anchor.y = attributes.number("y", mostTrekCoordinate_m);
        anchor.z = attributes.number("z", mostTrekCoordinate_m);
        std::vector<RangeCorrection> corrections;
        for (int tag = 0; tag < trekTags; ++tag)
            if (const double cm = attributes.number(correctionName(tag).c_str(), mostCorrection_cm);
                cm != 0.0)
                corrections.push_back({anchor.id, tag, cm / cmPerMetre});
        std::string reason = attributes.reason();
        if (reason.empty() && !used.insert(anchor.id).second)
            reason = "<anc>: ID " + std::to_string(anchor.id) + " is used twice; every anchor has its own";
        if (!reason.empty()) {
            config.problems.add(lineAt(text, element.offset_debug()), std::move(reason));
            continue;
        }
        config.anchors.push_back(std::move(anchor));
        config.corrections.insert(config.corrections.end(), corrections.begin(), corrections.end());
    }
    return config;
}

Result<TrekTagConfig> readTrekTagConfig(std::string_view text)
{
    pugi::xml_document document;
    auto root = openConfig(document, text, "tag");
    if (!root)
        root = openConfig(document, text, "tag_cfg");
    if (!root)
        return std::unexpected(root.error());
    TrekTagConfig config;
    if (const pugi::xml_node element = root->child("tag_cfg")) {
        Attributes attributes(element);
        const double size_m = attributes.number("size", largestTag_m);
        const int history = attributes.integer("history", 10, mostHistory);
        if (attributes.reason().empty()) {
            config.drawnSize_m = std::abs(size_m);
            config.history = history;
        } else {
            config.problems.add(lineAt(text, element.offset_debug()), attributes.reason());
        }
    }
    for (const pugi::xml_node& element : root->children("tag")) {
        Attributes attributes(element);
        const int id = attributes.integer("ID", 16, mostTrekId);
        if (attributes.reason().empty())
            config.tags.push_back({id, attributes.label("Tag " + std::to_string(id))});
        else
            config.problems.add(lineAt(text, element.offset_debug()), attributes.reason());
    }
    return config;
}

std::string writeTrekAnchorConfig(const std::vector<UwbAnchor>& anchors,
                                  const std::vector<RangeCorrection>& corrections)
{
    pugi::xml_document document;
    pugi::xml_node config = document.append_child("config");
    for (const UwbAnchor& anchor : anchors) {
        pugi::xml_node element = config.append_child("anc");
        element.append_attribute("ID") = anchor.id;
        element.append_attribute("label") = anchor.label.c_str();
        element.append_attribute("x") = exactNumberText(anchor.x).c_str();
        element.append_attribute("y") = exactNumberText(anchor.y).c_str();
        element.append_attribute("z") = exactNumberText(anchor.z).c_str();
        for (int tag = 0; tag < trekTags; ++tag) {
            const auto isThis = [&](const RangeCorrection& c) {
                return c.anchor == anchor.id && c.tag == tag;
            };
            const auto found = std::ranges::find_if(corrections, isThis);
            const double cm = found == corrections.end() ? 0.0 : found->offset_m * cmPerMetre;
            element.append_attribute(correctionName(tag).c_str()) = numberText(cm).c_str();
        }
    }
    return textOf(document);
}

std::string writeTrekTagConfig(const TrekTagConfig& config)
{
    pugi::xml_document document;
    pugi::xml_node root = document.append_child("config");
    pugi::xml_node settings = root.append_child("tag_cfg");
    settings.append_attribute("size") = exactNumberText(config.drawnSize_m).c_str();
    settings.append_attribute("history") = config.history;
    for (const TrekTag& tag : config.tags) {
        char id[16]{};
        *std::to_chars(id, id + sizeof id - 1, tag.id, 16).ptr = '\0';
        pugi::xml_node element = root.append_child("tag");
        element.append_attribute("ID") = id;
        element.append_attribute("label") = tag.label.c_str();
    }
    return textOf(document);
}

} // namespace agv::recording
