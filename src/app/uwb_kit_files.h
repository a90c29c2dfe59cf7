// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace agv::app {

/// The UWB kit of a plant with what a file brought, and what to know about it.
struct ImportedUwb {
    std::vector<UwbAnchor> anchors;
    UwbSettings settings;
    std::vector<std::string> notes; ///< plain English
};

/// What the file holds, told from its content, takes the place of the same in `plant`:
/// * a table of anchors (recording/anchor_csv.h): the anchors;
/// * TREKanc_config.xml: the anchors, and their corrections for the tags 0 to 7;
/// * TREKtag_config.xml: the labels of the tags; tags that are new are added;
/// * a plant file: anchors, tags and corrections, not the port, which belongs to a computer.
/// Corrections of anchors that are gone go with them. The errors of readTextFile(), or BadInput that names
/// file and line; also when the plant would break a rule of the plant file.
Result<ImportedUwb> importUwb(const std::filesystem::path& path, const PlantLayout& plant);

/// Writes a table of anchors, or TREKanc_config.xml when the name ends with ".xml". Returns what was written
/// and what the format has no place for, as a sentence. The errors of writeTextFile().
Result<std::string> exportUwb(const std::filesystem::path& path, const std::vector<UwbAnchor>& anchors,
                              const UwbSettings& settings);

/// Writes anchors, tags, corrections and port into a plant file. The file is read anew first, so that what
/// somebody else changed since the start stays, as does every key this version does not know. The errors of
/// PlantDocument::fromFile() and writePlantFile(); then the file is as it was.
Result<void> saveUwb(const std::filesystem::path& path, const std::vector<UwbAnchor>& anchors,
                     const UwbSettings& settings);

} // namespace agv::app
