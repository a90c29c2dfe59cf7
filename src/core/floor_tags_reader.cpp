// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/floor_tags_reader.h"

#include <limits>

namespace agv {
namespace {

// In the units of the file; docs/plant-file.md lists them.
constexpr NumberRange tagRadiusRange{0, 1000};
constexpr NumberRange pitchRange{1, 10'000};
constexpr int mostTagsOfAGrid = 250'000;
constexpr int mostTagNumber = 1'000'000'000;

TagUid readUid(JsonFields& fields, std::string_view key)
{
    const std::size_t before = fields.findings().errors.size();
    const std::string text = fields.text(key, std::nullopt);
    if (fields.findings().errors.size() != before)
        return {};
    const auto uid = parseTagUid(text);
    if (!uid)
        fields.error(key, "must be a tag UID, 1 to 16 hexadecimal digits such as \"E00401503A5BDAE4\" (is " +
                              describe(*fields.find(key)) + ")");
    return uid.value_or(TagUid{});
}

TagGridSpec readGridFields(JsonFields& fields)
{
    TagGridSpec grid;
    grid.columns = fields.integer("columns", 1, 10'000, std::nullopt);
    grid.rows = fields.integer("rows", 1, 10'000, std::nullopt);
    grid.pitch_m = fields.thousandths("pitch_mm", pitchRange, std::nullopt);
    grid.origin = readPoint(fields, "origin_mm");
    grid.firstUid = readUid(fields, "first_uid");
    return grid;
}

} // namespace

void FloorTagReader::read(JsonFields& parent, PlantLayout& plant)
{
    const Json* const json = parent.object("floor_tags");
    if (json == nullptr)
        return;
    JsonFields fields(*json, parent.pointerTo("floor_tags"), m_findings);
    plant.tagRadius_m = fields.thousandths("radius_mm", tagRadiusRange, plant.tagRadius_m);
    if (const Json* const grid = fields.object("grid"))
        readGrid(*grid, fields.pointerTo("grid"));
    readEach(fields, "list", m_findings, [this](JsonFields& item) { readTag(item); });
    fields.finish();
    plant.floorTags = std::move(m_tags);
}

void FloorTagReader::readGrid(const Json& json, const std::string& pointer)
{
    JsonFields fields(json, pointer, m_findings);
    const std::size_t before = m_findings.errors.size();
    const TagGridSpec grid = readGridFields(fields);
    fields.finish();
    if (m_findings.errors.size() != before)
        return;
    const int count = grid.columns * grid.rows;
    if (count > mostTagsOfAGrid)
        fields.error("rows", "gives " + std::to_string(count) + " tags; at most " +
                                 std::to_string(mostTagsOfAGrid) + " are allowed");
    else if (grid.firstUid.value >
             std::numeric_limits<std::uint64_t>::max() - static_cast<std::uint64_t>(count))
        fields.error("first_uid", "is too large for " + std::to_string(count) + " tags counted up from it");
    else
        addGrid(grid, pointer);
}

void FloorTagReader::addGrid(const TagGridSpec& grid, const std::string& pointer)
{
    m_tags = expand(grid);
    m_gridTags = m_tags.size();
    const FloorTag& last = m_tags.back();
    const char* const culprit = m_area.isEastOf(last.position) ? "/columns" : "/rows";
    m_area.requireInside(grid.origin, pointer + "/origin_mm", "tag 1 of the grid", m_findings);
    m_area.requireInside(last.position, pointer + culprit,
                         "tag " + std::to_string(last.number) + " of the grid", m_findings);
    m_used.reserve(m_tags.size());
    for (std::size_t i = 0; i < m_tags.size(); ++i)
        m_used.emplace(m_tags[i].uid, i);
}

void FloorTagReader::readTag(JsonFields& fields)
{
    FloorTag tag;
    tag.uid = readUid(fields, "uid");
    tag.position = readPosition(fields);
    tag.number = fields.integer("number", 0, mostTagNumber, static_cast<int>(m_tags.size()) + 1);
    if (m_findings.errors.empty()) {
        const auto [first, isNew] = m_used.emplace(tag.uid, m_tags.size());
        if (!isNew)
            fields.error("uid", "tag " + fullText(tag.uid) + " is already used by " +
                                    whereUsed(first->second) + "; every tag has its own UID");
        m_area.requireInside(tag.position, fields.pointer(), "the tag", m_findings);
    }
    m_tags.push_back(tag);
}

std::string FloorTagReader::whereUsed(std::size_t index) const
{
    if (index < m_gridTags)
        return "/floor_tags/grid (tag " + std::to_string(index + 1) + ")";
    return "/floor_tags/list/" + std::to_string(index - m_gridTags) + "/uid";
}

std::optional<TagGridSpec> gridOf(const Json& root)
{
    const Json::json_pointer place("/floor_tags/grid");
    if (!root.contains(place))
        return std::nullopt;
    JsonFindings findings;
    JsonFields fields(root.at(place), "", findings);
    const TagGridSpec grid = readGridFields(fields);
    return findings.errors.empty() ? std::optional(grid) : std::nullopt;
}

} // namespace agv
