// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/uwb_kit_files.h"

#include "app/uwb_files.h"
#include "core/file_units.h"
#include "core/plant_file.h"
#include "core/text_file.h"
#include "recording/anchor_csv.h"
#include "recording/text_lines.h"
#include "recording/trek_config.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace agv::app {
namespace {

namespace fs = std::filesystem;

constexpr int trekTags = 8; ///< tags that TREKanc_config.xml has corrections of
constexpr std::size_t mostProblemNotes = 5;

void addProblems(ImportedUwb& kit, const std::string& name, const recording::FileProblems& problems)
{
    const std::size_t told = std::min(mostProblemNotes, problems.kept().size());
    for (std::size_t i = 0; i < told; ++i)
        kit.notes.push_back("Left out: " + problemText(name, problems.kept()[i]));
    if (problems.count() > told)
        kit.notes.push_back("Left out: " + std::to_string(problems.count() - told) + " more");
}

bool has(const std::vector<UwbAnchor>& anchors, int id)
{
    return std::ranges::find(anchors, id, &UwbAnchor::id) != anchors.end();
}

void replaceAnchors(ImportedUwb& kit, std::vector<UwbAnchor> anchors)
{
    kit.anchors = std::move(anchors);
    std::erase_if(kit.settings.corrections,
                  [&](const RangeCorrection& correction) { return !has(kit.anchors, correction.anchor); });
}

void take(ImportedUwb& kit, const std::string& name, recording::TrekAnchorConfig config)
{
    replaceAnchors(kit, std::move(config.anchors));
    std::vector<RangeCorrection>& corrections = kit.settings.corrections;
    std::erase_if(corrections, [](const RangeCorrection& correction) { return correction.tag < trekTags; });
    corrections.insert(corrections.end(), config.corrections.begin(), config.corrections.end());
    addProblems(kit, name, config.problems);
}

void take(ImportedUwb& kit, const std::string& name, const recording::TrekTagConfig& config)
{
    std::vector<UwbTag>& tags = kit.settings.tags;
    bool anyNew = false;
    for (const recording::TrekTag& tag : config.tags) {
        const auto known = std::ranges::find(tags, tag.id, &UwbTag::id);
        if (known != tags.end()) {
            known->label = tag.label;
            continue;
        }
        anyNew = true;
        tags.push_back({tag.id, tag.label, std::nullopt, kit.settings.tagHeight_m, {}});
    }
    if (anyNew)
        kit.notes.push_back("The file has no heights: the new tags have " +
                            std::to_string(std::lround(toThousandths(kit.settings.tagHeight_m))) +
                            " mm until you enter their own");
    addProblems(kit, name, config.problems);
}

Result<void> takePlant(ImportedUwb& kit, std::string_view text, const std::string& name)
{
    Result<PlantLayout> plant = readPlantText(text, name);
    if (!plant)
        return std::unexpected(plant.error());
    if (plant->anchors.empty() && plant->uwb.tags.empty())
        return failure(ErrorCode::BadInput, name + ": this plant file has no UWB anchors and no UWB tags");
    plant->uwb.port = kit.settings.port;
    plant->uwb.dialect = kit.settings.dialect;
    kit.anchors = std::move(plant->anchors);
    kit.settings = std::move(plant->uwb);
    return {};
}

Result<void> takeXml(ImportedUwb& kit, std::string_view text, const std::string& name)
{
    if (auto anchors = recording::readTrekAnchorConfig(text)) {
        take(kit, name, std::move(*anchors));
        return {};
    } else if (const auto tags = recording::readTrekTagConfig(text)) {
        take(kit, name, *tags);
        return {};
    } else {
        return std::unexpected(inFile(name, anchors.error()));
    }
}

Result<void> takeTable(ImportedUwb& kit, std::string_view text, const std::string& name)
{
    auto anchors = recording::readAnchorCsv(text);
    if (!anchors)
        return std::unexpected(inFile(name, anchors.error()));
    replaceAnchors(kit, std::move(*anchors));
    return {};
}

Result<void> takeText(ImportedUwb& kit, std::string_view text, const std::string& name)
{
    const std::string_view begin = recording::trimmed(text.substr(0, 256));
    if (begin.starts_with('{'))
        return takePlant(kit, text, name);
    if (begin.starts_with('<') || begin.starts_with("\xef\xbb\xbf<"))
        return takeXml(kit, text, name);
    return takeTable(kit, text, name);
}

} // namespace

Result<ImportedUwb> importUwb(const fs::path& path, const PlantLayout& plant)
{
    const auto text = readTextFile(path, maxPlantFileBytes);
    if (!text)
        return std::unexpected(text.error());
    ImportedUwb kit{plant.anchors, plant.uwb, {}};
    if (const auto taken = takeText(kit, *text, path.string()); !taken)
        return std::unexpected(taken.error());
    PlantLayout changed = plant;
    changed.anchors = kit.anchors;
    changed.uwb = kit.settings;
    if (const auto written = plantText(changed); !written)
        return std::unexpected(inFile(path.string(), written.error()));
    return kit;
}

Result<std::string> exportUwb(const fs::path& path, const std::vector<UwbAnchor>& anchors,
                              const UwbSettings& settings)
{
    const bool isTrek = path.extension() == ".xml";
    const auto written =
        writeTextFile(path, isTrek ? recording::writeTrekAnchorConfig(anchors, settings.corrections)
                                   : recording::writeAnchorCsv(anchors));
    if (!written)
        return std::unexpected(written.error());
    if (isTrek)
        return "Anchors and the corrections of the tags 0 to 7 are written to " + path.string();
    return "Anchors are written to " + path.string() + "; tags and corrections have no place in that format";
}

Result<void> saveUwb(const fs::path& path, const std::vector<UwbAnchor>& anchors, const UwbSettings& settings)
{
    const Result<PlantDocument> document = PlantDocument::fromFile(path);
    if (!document)
        return std::unexpected(document.error());
    PlantLayout layout = document->layout();
    layout.anchors = anchors;
    layout.uwb = settings;
    return writePlantFile(path, layout, &*document);
}

} // namespace agv::app
