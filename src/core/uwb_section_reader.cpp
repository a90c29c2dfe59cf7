// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/uwb_section_reader.h"

#include <algorithm>

namespace agv {
namespace {

constexpr NumberRange mountRange{-2000, 2000};
constexpr int mostTags = 255;
constexpr int mostAnchors = 255;
/// Antenna delays and clocks err by less than a metre; ten are a slip of the pen.
constexpr NumberRange offsetRange{-10'000, 10'000};

/// "trek", "trek-1.06", ... with the word for none chosen.
std::string dialectWords()
{
    std::string words = "\"" + std::string(detectedDialect) + "\"";
    for (std::size_t i = 1; i < uwbDialectCount; ++i)
        words += std::string(i + 1 < uwbDialectCount ? ", \"" : " or \"") +
                 toText(static_cast<UwbDialect>(i)) + "\"";
    return words;
}

} // namespace

void UwbSectionReader::read(JsonFields& root, PlantLayout& plant)
{
    const Json* const json = root.object("uwb");
    if (json == nullptr)
        return;
    JsonFields fields(*json, root.pointerTo("uwb"), m_findings);
    UwbSettings& uwb = plant.uwb;
    uwb.port.path = fields.text("port", uwb.port.path);
    uwb.port.usb = readUsbId(fields);
    uwb.port.serialNumber = fields.text("serial_number", uwb.port.serialNumber);
    uwb.dialect = readDialect(fields);
    uwb.tagHeight_m = fields.thousandths("tag_height_mm", coordinateRange, uwb.tagHeight_m);
    readEach(fields, "tags", m_findings, [&](JsonFields& item) { readTag(item, plant); });
    readEach(fields, "corrections", m_findings, [&](JsonFields& item) { readCorrection(item, plant); });
    fields.finish();
}

std::optional<UsbId> UwbSectionReader::readUsbId(JsonFields& fields)
{
    const std::string text = fields.text("usb_id", "");
    if (text.empty())
        return std::nullopt;
    if (const auto id = parseUsbId(text))
        return *id;
    fields.error("usb_id", "must be vendor and product in hexadecimal, such as \"0483:5740\" (is " +
                               describe(*fields.find("usb_id")) + ")");
    return std::nullopt;
}

std::optional<UwbDialect> UwbSectionReader::readDialect(JsonFields& fields)
{
    const std::string word = fields.text("dialect", std::string(detectedDialect));
    const auto dialect = parseUwbDialect(word);
    if (dialect && *dialect != UwbDialect::Unknown)
        return dialect;
    if (word != detectedDialect)
        fields.error("dialect",
                     "must be " + dialectWords() + " (is " + describe(*fields.find("dialect")) + ")");
    return std::nullopt;
}

void UwbSectionReader::readTag(JsonFields& fields, PlantLayout& plant)
{
    UwbTag tag;
    tag.id = fields.integer("id", 0, mostTags, std::nullopt);
    tag.label = fields.text("label", "T" + std::to_string(tag.id));
    const int agv = fields.integer("agv", 0, highestAgv, 0);
    if (agv != 0)
        tag.agv = RobotId{agv};
    tag.z_m = fields.thousandths("z_mm", coordinateRange, plant.uwb.tagHeight_m);
    tag.mount.x = fields.thousandths("along_mm", mountRange, tag.mount.x);
    tag.mount.y = fields.thousandths("across_mm", mountRange, tag.mount.y);
    if (tag.agv && plant.findAgv(*tag.agv) == nullptr)
        fields.error("agv", "there is no AGV number " + std::to_string(agv) +
                                " in \"agvs\"; enter the AGV that carries the tag, or 0 for none");
    const auto [first, isNew] = m_usedTags.emplace(tag.id, fields.pointerTo("id"));
    if (!isNew)
        fields.error("id", "tag number " + std::to_string(tag.id) + " is already used by " + first->second);
    plant.uwb.tags.push_back(std::move(tag));
}

void UwbSectionReader::readCorrection(JsonFields& fields, PlantLayout& plant)
{
    const std::size_t before = m_findings.errors.size();
    RangeCorrection correction;
    correction.anchor = fields.integer("anchor", 0, mostAnchors, std::nullopt);
    correction.tag = fields.integer("tag", 0, mostTags, std::nullopt);
    correction.offset_m = fields.thousandths("offset_mm", offsetRange, std::nullopt);
    if (m_findings.errors.size() != before)
        return;
    const std::string anchor = std::to_string(correction.anchor);
    if (std::ranges::find(plant.anchors, correction.anchor, &UwbAnchor::id) == plant.anchors.end())
        fields.error("anchor",
                     "there is no anchor number " + anchor +
                         " in \"anchors\"; enter an anchor of the list, or leave the correction out");
    const auto [first, isNew] =
        m_usedCorrections.emplace(std::pair(correction.anchor, correction.tag), fields.pointer());
    if (!isNew)
        fields.error("anchor", "anchor " + anchor + " and tag " + std::to_string(correction.tag) +
                                   " are already corrected by " + first->second);
    plant.uwb.corrections.push_back(correction);
}

} // namespace agv
