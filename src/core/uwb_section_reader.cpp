// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/uwb_section_reader.h"

namespace agv {
namespace {

constexpr NumberRange mountRange{-2000, 2000};
constexpr int mostTags = 255;

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

} // namespace agv
