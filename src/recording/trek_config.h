// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"
#include "recording/file_problem.h"

#include <string>
#include <string_view>
#include <vector>

/// The settings files of the program DecaRangeRTLS.
namespace agv::recording {

/// TREKanc_config.xml: <config><anc ID="0" label="A0" x="0" y="0" z="2" t0="0" ... t7="0"/></config>,
/// metres, corrections in cm.
struct TrekAnchorConfig {
    std::vector<UwbAnchor> anchors;
    std::vector<RangeCorrection> corrections; ///< those that are not 0
    FileProblems problems;                    ///< anchors left out
};

struct TrekTag {
    int id = 0;
    std::string label;
    friend bool operator==(const TrekTag&, const TrekTag&) = default;
};

/// TREKtag_config.xml: <config><tag_cfg size="0.15" history="20"/><tag ID="5" label="Tag 5"/></config>; the
/// ID is hexadecimal.
struct TrekTagConfig {
    double drawnSize_m = 0.15;
    int history = 20; ///< positions shown of each tag
    std::vector<TrekTag> tags;
    FileProblems problems; ///< tags left out
};

/// An element that cannot be used is a problem and never stops the others; what an anchor leaves out is 0, as
/// in the program itself. BadInput "LINE: ..." when the text is not XML, or not of this kind.
Result<TrekAnchorConfig> readTrekAnchorConfig(std::string_view text);
Result<TrekTagConfig> readTrekTagConfig(std::string_view text);

/// Files that the program reads. It knows ids 0 to 7 only: corrections of other tags are left out.
std::string writeTrekAnchorConfig(const std::vector<UwbAnchor>& anchors,
                                  const std::vector<RangeCorrection>& corrections);
std::string writeTrekTagConfig(const TrekTagConfig& config);

} // namespace agv::recording
