// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_file.h"

#include "core/json_location.h"
#include "core/plant_file_reader.h"
#include "core/plant_file_writer.h"
#include "core/text_file.h"

#include <algorithm>
#include <map>

namespace agv {

struct PlantDocument::Content {
    PlantLayout layout;
    std::vector<std::string> warnings;
    Json tree;
};

namespace {

constexpr std::size_t mostWarnings = 50;

std::string_view withoutByteOrderMark(std::string_view text)
{
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

/// Where the value at a pointer begins, or what would hold it when it is absent.
std::size_t nearestOffset(std::string_view text, std::string_view pointer)
{
    while (true) {
        if (const auto offset = locateValue(text, pointer))
            return *offset;
        if (pointer.empty())
            return 0;
        pointer = pointer.substr(0, pointer.rfind('/'));
    }
}

std::string withPlace(const JsonProblem& problem, std::string_view text, std::string_view name)
{
    const std::size_t offset = nearestOffset(text, problem.pointer);
    const std::string where = problem.pointer.empty() ? "" : problem.pointer + ": ";
    return placeText(name, text, offset) + where + problem.text;
}

/// The one that stands first in the text.
const JsonProblem& firstOf(const std::vector<JsonProblem>& problems, std::string_view text)
{
    std::vector<std::size_t> offsets;
    offsets.reserve(problems.size());
    for (const JsonProblem& problem : problems)
        offsets.push_back(nearestOffset(text, problem.pointer));
    return problems[static_cast<std::size_t>(std::min_element(offsets.begin(), offsets.end()) -
                                             offsets.begin())];
}

/// In the order of the text.
std::vector<std::string> warningTexts(const std::vector<JsonProblem>& problems, std::string_view text,
                                      std::string_view name)
{
    std::map<std::size_t, std::string> byPlace;
    for (const JsonProblem& problem : problems) {
        if (byPlace.size() == mostWarnings)
            break;
        const std::size_t offset = locateKey(text, problem.pointer).value_or(0);
        byPlace[offset] = placeText(name, text, offset) + problem.pointer + ": " + problem.text;
    }
    std::vector<std::string> lines;
    for (auto& [offset, line] : byPlace)
        lines.push_back(std::move(line));
    if (problems.size() > mostWarnings)
        lines.push_back(std::string(name) + ": " + std::to_string(problems.size() - mostWarnings) +
                        " more unknown keys");
    return lines;
}

} // namespace

Result<PlantDocument> PlantDocument::fromText(std::string_view text, std::string_view name)
{
    text = withoutByteOrderMark(text);
    if (text.size() > maxPlantFileBytes)
        return failure(ErrorCode::BadInput, std::string(name) + ": is larger than 64 MB; no plant file is");
    auto tree = parseJson(text, name);
    if (!tree)
        return std::unexpected(std::move(tree.error()));
    JsonFindings findings;
    PlantLayout layout = readPlant(*tree, findings);
    if (!findings.errors.empty())
        return failure(ErrorCode::BadInput, withPlace(firstOf(findings.errors, text), text, name));
    return PlantDocument(std::make_shared<Content>(
        Content{std::move(layout), warningTexts(findings.warnings, text, name), std::move(*tree)}));
}

Result<PlantDocument> PlantDocument::fromFile(const std::filesystem::path& path)
{
    const auto text = readTextFile(path, maxPlantFileBytes);
    if (!text)
        return std::unexpected(text.error());
    return fromText(*text, path.string());
}

const PlantLayout& PlantDocument::layout() const { return m_content->layout; }

const std::vector<std::string>& PlantDocument::warnings() const { return m_content->warnings; }

Result<PlantLayout> readPlantText(std::string_view text, std::string_view name)
{
    const auto document = PlantDocument::fromText(text, name);
    if (!document)
        return std::unexpected(document.error());
    return document->layout();
}

Result<PlantLayout> readPlantFile(const std::filesystem::path& path)
{
    const auto document = PlantDocument::fromFile(path);
    if (!document)
        return std::unexpected(document.error());
    return document->layout();
}

Result<std::string> plantText(const PlantLayout& layout, const PlantDocument* original)
{
    const Json* const tree = original == nullptr ? nullptr : &original->content().tree;
    std::string text = printJson(plantTree(layout, tree));
    // What could not be read again must never replace a file.
    const auto readBack = readPlantText(text, "the new plant file");
    if (!readBack)
        return std::unexpected(readBack.error());
    if (*readBack != layout)
        return failure(ErrorCode::BadInput,
                       "the layout cannot be kept in a plant file: a heading is not in (-180, 180] degrees");
    return text;
}

Result<void> writePlantFile(const std::filesystem::path& path, const PlantLayout& layout,
                            const PlantDocument* original)
{
    const auto text = plantText(layout, original);
    if (!text)
        return failure(text.error().code, path.string() + ": not written; " + text.error().detail);
    return writeTextFile(path, *text);
}

} // namespace agv
