// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace agv {

/// A plant file as it was read: the layout it describes, what is odd about it, and everything in it that
/// this version does not know, so that a changed layout can be written back without losing a word.
/// A value; cheap to copy.
class PlantDocument {
public:
    /// Reads the text of a plant file (docs/plant-file.md); `name` stands in front of every message.
    /// BadInput names the first place that is wrong as "name:line:column: /pointer: what, what to do".
    static Result<PlantDocument> fromText(std::string_view text, std::string_view name);

    /// Reads a plant file of at most maxPlantFileBytes. NotFound, Permission, Io, or BadInput as above.
    static Result<PlantDocument> fromFile(const std::filesystem::path& path);

    const PlantLayout& layout() const;

    /// One line for each key this version does not know, with its place and the key that was perhaps meant.
    const std::vector<std::string>& warnings() const;

    struct Content;
    const Content& content() const { return *m_content; }

private:
    explicit PlantDocument(std::shared_ptr<const Content> content) : m_content(std::move(content)) {}
    std::shared_ptr<const Content> m_content;
};

/// Larger files are refused: no plant needs them, and they would only be a mistake.
inline constexpr std::size_t maxPlantFileBytes = std::size_t{64} * 1024 * 1024;

/// The layout alone of PlantDocument::fromText().
Result<PlantLayout> readPlantText(std::string_view text, std::string_view name);

/// The layout alone of PlantDocument::fromFile().
Result<PlantLayout> readPlantFile(const std::filesystem::path& path);

/// The text of a plant file that reads back as exactly this layout. With an `original`, its order of keys,
/// its unknown keys and its omitted defaults are kept. BadInput when the layout breaks a rule of the format.
Result<std::string> plantText(const PlantLayout& layout, const PlantDocument* original = nullptr);

/// Writes plantText() so that the file holds the old or the new text at every instant, whatever fails.
Result<void> writePlantFile(const std::filesystem::path& path, const PlantLayout& layout,
                            const PlantDocument* original = nullptr);

} // namespace agv
